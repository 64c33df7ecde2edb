/* Weft: figures/list.h, tangled from chapters/engine/04-design.nw. Chapters that add to it:
 * memory.figures, numbers.figures, shapes.figures, bodies.figures, forces.figures,
 * integration.figures, broad-phase.figures, narrow-phase.figures, contacts.figures,
 * impulses.figures, friction.figures, sequential.figures, soft.figures, joints.figures,
 * exact.figures, compound.figures, time-of-impact.figures, islands.figures,
 * events-and-queries.figures, world.figures, joints-in-a-world.figures, save-and-replay.figures,
 * platform.figures, drawing-pixels.figures, headless.figures, accuracy.figures, primer.figures. Do
 * not edit this file: edit the chapter and type make. MIT licence. */
/* chapters with figures */
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
CHAPTER(headless)
CHAPTER(accuracy)
CHAPTER(primer)
