/* Weft: lab/list.h, tangled from chapters/engine/04-design.nw. Chapters that add to it: memory.lab,
 * numbers.lab, shapes.lab, bodies.lab, forces.lab, integration.lab, broad-phase.lab,
 * narrow-phase.lab, contacts.lab, impulses.lab, friction.lab, sequential.lab, soft.lab, joints.lab,
 * exact.lab, compound.lab, time-of-impact.lab, islands.lab, events-and-queries.lab, world.lab,
 * joints-in-a-world.lab, save-and-replay.lab, platform.lab, drawing-pixels.lab, classics,
 * headless.lab, black-box-tests.lab, performance, accuracy.lab, tolerance.lab, price-list. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
/* chapters with measurements */
CHAPTER(design)
CHAPTER(memory)
CHAPTER(numbers)
CHAPTER(shapes)
CHAPTER(bodies)
CHAPTER(forces)
CHAPTER(integration)
CHAPTER(broad_phase)
CHAPTER(narrow_phase)
CHAPTER(contacts)
CHAPTER(impulses)
CHAPTER(friction)
CHAPTER(sequential)
CHAPTER(soft)
CHAPTER(joints)
CHAPTER(exact)
CHAPTER(compound)
CHAPTER(time_of_impact)
CHAPTER(islands)
CHAPTER(events_and_queries)
CHAPTER(world)
CHAPTER(joints_in_a_world)
CHAPTER(save_and_replay)
CHAPTER(platform)
CHAPTER(drawing_pixels)
CHAPTER(classics)
CHAPTER(headless)
CHAPTER(black_box_tests)
CHAPTER(performance)
CHAPTER(accuracy)
CHAPTER(tolerance)
CHAPTER(price_list)
