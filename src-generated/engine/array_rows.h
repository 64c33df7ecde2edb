/* Weft: engine/array_rows.h, tangled from chapters/engine/20-world.nw. Chapters that add to it:
 * bodies-in-a-world, step, joints-in-a-world, continuous-collision, sleep-in-a-world. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* The arrays of a world in the order in which they lie. For those who define WF_KEPT and
 * WF_FRESH: WF_KEPT(NAME, pointer, "name", per, type, modules, stage, rule) in the
 * permanent chunk, WF_FRESH(NAME, "name", per, type, modules, stage) in the other. */
/* arrays that are kept */
WF_KEPT(HEADER, head, "header", WF_PER_WORLD, wfHeader, 0, NULL, header)
WF_KEPT(BODY_SLOTS, bodySlots, "body slots", WF_PER_BODY, wfSlot, 0, NULL, body_slots)
/* 1: a live body; WF_DISABLED: a live one that takes no part in steps */
WF_KEPT(ALIVE, alive, "alive", WF_PER_BODY, uint8_t, 0, NULL, bodies)
WF_KEPT(STATE, state, "states", WF_PER_BODY, wfBodyState, 0, NULL, bodies)
WF_KEPT(APPLIED, applied, "applied forces", WF_PER_BODY, wfBodyForces, WF_MODULE_PUSHES,
        NULL, applied)  /* what the user applied for the next step */
WF_KEPT(PROPS, props, "properties", WF_PER_BODY, wfBodyProps, 0, NULL, bodies)
WF_KEPT(SHAPE_SLOTS, shapeSlots, "shape slots", WF_PER_SHAPE, wfSlot, WF_MODULE_SHAPES,
        NULL, shape_slots)
/* relative to the centre of mass */
WF_KEPT(SHAPES, shapes, "shapes", WF_PER_SHAPE, wfShape, WF_MODULE_SHAPES, NULL, shapes)
/* the body of a shape, or -1: an empty place */
WF_KEPT(OWNERS, bodyOfShape, "owners of shapes", WF_PER_SHAPE, int32_t, WF_MODULE_SHAPES,
        NULL, shapes)
/* the next shape of the same body, or -1 */
WF_KEPT(NEXT_SHAPES, next, "next shapes", WF_PER_SHAPE, int32_t, WF_MODULE_SHAPES, NULL,
         shapes)
WF_KEPT(FILTERS, filters, "filters", WF_PER_SHAPE, wfFilter, WF_MODULE_SHAPES, NULL, any)
WF_KEPT(SHAPE_PROPS, materials, "materials", WF_PER_SHAPE, wfShapeProps, WF_MODULE_SHAPES,
         NULL, shapes)
/* of the shapes as they stand */
WF_KEPT(BOUNDS, bounds, "bounds", WF_PER_SHAPE, wfRect,
        WF_MODULE_CONTACTS | WF_MODULE_QUERIES, "bounds", bounds)
WF_KEPT(FLAGS, flags, "flags", WF_PER_SHAPE, uint8_t,
        WF_MODULE_CONTACTS | WF_MODULE_QUERIES, "bounds", bounds)
WF_KEPT(INDEX, index, "index", WF_BYTES_OF_INDEX, uint8_t,
         WF_MODULE_CONTACTS | WF_MODULE_QUERIES, "broad phase", any)  /* built anew */
WF_KEPT(FORCE_SLOTS, forceSlots, "force slots", WF_PER_FORCE, wfSlot, WF_MODULE_FORCES,
        NULL, force_slots)
WF_KEPT(FORCES, forces, "forces", WF_PER_FORCE, wfForce, WF_MODULE_FORCES, NULL, forces)
WF_KEPT(ADDED, added, "times of forces", WF_PER_FORCE, double, WF_MODULE_FORCES, NULL,
        forces)
/* of the last step */
WF_KEPT(PAIRS, pairs, "pairs", WF_PER_PAIR, wfPair, WF_MODULE_CONTACTS, "broad phase",
        pairs)
WF_KEPT(CACHES, caches, "caches", WF_PER_PAIR, wfManifoldCache, WF_MODULE_CONTACTS,
         "narrow phase", pairs)  /* one for each pair */
WF_KEPT(CONTACTS, contacts, "contacts", WF_PER_CONTACT, wfContact, WF_MODULE_CONTACTS,
         "narrow phase", contacts)
WF_KEPT(TOUCHES, touches, "touches", WF_PER_TOUCH, wfTouchingPair, WF_MODULE_CONTACTS,
         "narrow phase", touches)  /* of the last step */
WF_KEPT(EVENTS, events, "events", WF_PER_EVENT, wfContactEvent, WF_MODULE_EVENTS, "events",
         events)
WF_KEPT(HITS, hits, "hits", WF_PER_TOUCH, wfContactHit, WF_MODULE_EVENTS, "narrow phase",
        hits)
WF_KEPT(PAIR_MATERIALS, known, "pairs of materials", WF_PER_PAIR_MATERIAL, wfKnownPair,
         WF_MODULE_MATERIALS, NULL, materials)
/* what states round away */
WF_KEPT(FINE, fine, "digits beyond states", WF_PER_FINE_BODY, wfResidual, 0, NULL, fine)
WF_KEPT(JOINT_SLOTS, jointSlots, "joint slots", WF_PER_JOINT, wfSlot, WF_MODULE_JOINTS,
        NULL, joint_slots)
WF_KEPT(JOINTS, joints, "joints", WF_PER_JOINT, wfJoint, WF_MODULE_JOINTS, "keep joints",
         joints)
WF_KEPT(BROKEN, broken, "broken joints", WF_PER_JOINT, wfJointId, WF_MODULE_JOINTS,
         "keep joints", broken)
WF_KEPT(ALONE, alone, "joints alone", WF_PER_JOINT, uint8_t, WF_MODULE_JOINTS,
        "keep joints", joints)
WF_KEPT(REST, rest, "rest", WF_PER_BODY, uint8_t, WF_MODULE_SLEEP, "islands", rest)
/* s: for so long it has been still */
WF_KEPT(CLOCKS, clocks, "clocks of rest", WF_PER_BODY, wfReal, WF_MODULE_SLEEP, "islands",
         rest)
WF_KEPT(RINGS, rings, "rings of sleepers", WF_PER_BODY, int32_t, WF_MODULE_SLEEP, "islands",
         rest)  /* of a sleeper: the next of its island */
/* the smallest index in its island, or -1 */
WF_KEPT(ISLANDS, islands, "islands", WF_PER_BODY, int32_t, WF_MODULE_SLEEP, "islands", rest)
/* arrays of a step */
WF_FRESH(NEW_STATE, "new states", WF_PER_BODY, wfBodyState, 0, "copy")
WF_FRESH(PRESENT, "present", WF_PER_BODY, uint8_t, 0, "copy")
WF_FRESH(ACTIVE_FORCES, "active forces", WF_PER_ACTIVE_FORCE, wfForce, 0, "forces")
WF_FRESH(AGES, "ages of forces", WF_PER_ACTIVE_FORCE, wfReal, 0, "forces")
WF_FRESH(SUMS, "sums of forces", WF_PER_BODY, wfBodyForces, WF_MODULE_SUBSTEPS, "integrate")
WF_FRESH(PLACES, "places", WF_PER_BODY, wfTransform,
         WF_MODULE_CONTACTS | WF_MODULE_QUERIES, "bounds")
WF_FRESH(PACES, "paces", WF_PER_SHAPE, wfPace,
         WF_MODULE_CONTACTS | WF_MODULE_QUERIES, "bounds")
WF_FRESH(NEW_BOUNDS, "new bounds", WF_PER_SHAPE, wfRect,
         WF_MODULE_CONTACTS | WF_MODULE_QUERIES, "bounds")
WF_FRESH(NEW_FLAGS, "new flags", WF_PER_SHAPE, uint8_t,
         WF_MODULE_CONTACTS | WF_MODULE_QUERIES, "bounds")
WF_FRESH(NEW_INDEX, "new index", WF_BYTES_OF_INDEX, uint8_t,
         WF_MODULE_CONTACTS | WF_MODULE_QUERIES, "broad phase")
WF_FRESH(NEW_PAIRS, "new pairs", WF_PER_PAIR, wfPair, WF_MODULE_CONTACTS, "broad phase")
WF_FRESH(NEW_CACHES, "new caches", WF_PER_PAIR, wfManifoldCache,
         WF_MODULE_CONTACTS, "narrow phase")
WF_FRESH(NEW_CONTACTS, "new contacts", WF_PER_CONTACT, wfContact,
         WF_MODULE_CONTACTS, "narrow phase")
WF_FRESH(NEW_TOUCHES, "new touches", WF_PER_TOUCH, wfTouchingPair,
         WF_MODULE_CONTACTS, "narrow phase")
WF_FRESH(TOLD, "told", WF_PER_CONTACT, wfTold, WF_MODULE_CONTACTS, "narrow phase")
WF_FRESH(NEW_EVENTS, "new events", WF_PER_EVENT, wfContactEvent, WF_MODULE_EVENTS, "events")
WF_FRESH(NEW_HITS, "new hits", WF_PER_TOUCH, wfContactHit, WF_MODULE_EVENTS, "narrow phase")
WF_FRESH(NEW_FINE, "new digits", WF_PER_FINE_BODY, wfResidual, 0, NULL)
WF_FRESH(NEW_JOINTS, "new joints", WF_PER_JOINT, wfJoint, WF_MODULE_JOINTS, "joints")
WF_FRESH(JOINT_PLACES, "places of joints", WF_PER_JOINT, int32_t,
         WF_MODULE_JOINTS, "joints")
WF_FRESH(JOINED, "joined bodies", WF_PER_JOINT, wfPair, WF_MODULE_JOINTS, "joined pairs")
WF_FRESH(JOINT_WORK, "rows of joints", WF_BYTES_OF_JOINT_ROWS, uint8_t,
         WF_MODULE_JOINTS, "joints")
WF_FRESH(EXACT, "matrix of joints", WF_BYTES_OF_MATRIX, uint8_t, WF_MODULE_JOINTS, "joints")
WF_FRESH(NEW_ALONE, "new joints alone", WF_PER_JOINT, uint8_t, WF_MODULE_JOINTS, "joints")
WF_FRESH(FLIGHTS, "flights", WF_PER_BODY, wfSweptBody, WF_MODULE_FAST, "impacts")
WF_FRESH(FLIGHT_OF, "flight of each body", WF_PER_BODY, int32_t, WF_MODULE_FAST, "impacts")
WF_FRESH(STRIKES, "strikes", WF_PER_PAIR, wfImpactEvent, WF_MODULE_FAST, "impacts")
WF_FRESH(SPARED, "spared pairs", WF_PER_SHAPE, wfPair, WF_MODULE_FAST, "impacts")
WF_FRESH(NEIGHBOURS, "shapes near a flight", WF_PER_SHAPE, int32_t, WF_MODULE_FAST,
         "impacts")
WF_FRESH(FRESH, "fresh flights", WF_PER_BODY, int32_t, WF_MODULE_FAST, "impacts")
WF_FRESH(LINKED, "bodies that joints hold", WF_PER_BODY, uint8_t, WF_MODULE_FAST, "bounds")
WF_FRESH(WOKEN, "woken", WF_PER_BODY, uint8_t, WF_MODULE_SLEEP, "copy")
WF_FRESH(NEW_CLOCKS, "new clocks of rest", WF_PER_BODY, wfReal, WF_MODULE_SLEEP, "islands")
WF_FRESH(NEW_ISLANDS, "new islands", WF_BYTES_OF_ISLANDS, uint8_t,
         WF_MODULE_SLEEP, "islands")
WF_FRESH(SCRATCH, "scratch", WF_BYTES_OF_SCRATCH, uint8_t, 0, NULL)
#undef WF_KEPT
#undef WF_FRESH
