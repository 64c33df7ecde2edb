/* Weft: figures/list.h, tangled from chapters/engine/04-design.nw. Chapters that add to it:
 * memory.figures, numbers.figures, shapes.figures, bodies.figures, forces.figures,
 * integration.figures, broad-phase.figures, narrow-phase.figures, contacts.figures,
 * impulses.figures, friction.figures, sequential.figures, soft.figures, joints.figures,
 * exact.figures, compound.figures, time-of-impact.figures, islands.figures,
 * events-and-queries.figures, world.figures, joints-in-a-world.figures, save-and-replay.figures,
 * platform.figures, drawing.figures, scenes, accuracy.figures, primer.figures. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* <chapters with figures> */
CHAPTER(design)
/* <chapters with figures> */
CHAPTER(memory)
/* <chapters with figures> */
CHAPTER(numbers)
/* <chapters with figures> */
CHAPTER(shapes)
/* <chapters with figures> */
CHAPTER(bodies)
/* <chapters with figures> */
CHAPTER(forces)
/* <chapters with figures> */
CHAPTER(integration)
/* <chapters with figures> */
CHAPTER(broad_phase)
/* <chapters with figures> */
CHAPTER(narrow_phase)
/* <chapters with figures> */
CHAPTER(contacts)
/* <chapters with figures> */
CHAPTER(impulses)
/* <chapters with figures> */
CHAPTER(friction)
/* <chapters with figures> */
CHAPTER(sequential)
/* <chapters with figures> */
CHAPTER(soft)
/* <chapters with figures> */
CHAPTER(joints)
/* <chapters with figures> */
CHAPTER(exact)
/* <chapters with figures> */
CHAPTER(compound)
/* <chapters with figures> */
CHAPTER(time_of_impact)
/* <chapters with figures> */
CHAPTER(islands)
/* <chapters with figures> */
CHAPTER(events_and_queries)
/* <chapters with figures> */
CHAPTER(world)
/* <chapters with figures> */
CHAPTER(joints_in_a_world)
/* <chapters with figures> */
CHAPTER(save_and_replay)
/* <chapters with figures> */
CHAPTER(platform)
/* <chapters with figures> */
CHAPTER(drawing)
/* <chapters with figures> */
CHAPTER(scenes)
/* <chapters with figures> */
CHAPTER(accuracy)
/* <chapters with figures> */
CHAPTER(primer)
