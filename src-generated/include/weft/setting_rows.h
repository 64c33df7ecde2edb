/* Weft: include/weft/setting_rows.h, tangled from chapters/engine/20-world.nw. Chapters that add to
 * it: bodies-in-a-world, step, joints-in-a-world, continuous-collision, sleep-in-a-world. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
/* The settings of a world in the order of their fields. For those who define
 * WF_SETTING(type, name, usual, text, ...), a field of wfWorldDef, and WF_ADVANCED, one of
 * its `advanced`: usual is the default; then members of wfSetting, as engine/settings.c
 * abbreviates them. Both are undefined here at the end. */
WF_SETTING(wfVec2, gravity, wfV2(0, WF_R(-9.81)),
           "acceleration of everything that has mass", .kind = WF_SETTING_VEC2, WF_ANY,
           .law = 1, .unit = "m/s^2")
WF_SETTING(wfReal, timeStep, WF_R(1.0) / 60, "length of a step", WF_REAL, WF_ABOVE(0),
           .unit = "s")
WF_SETTING(int32_t, bodyCapacity, 256, "bodies at most", WF_COUNTED, WF_CAPACITY(1))
WF_SETTING(int32_t, integrator, wfFindIntegrator("verlet"), "moves the bodies",
           WF_ROW(Integrator), .method = 1)
WF_SETTING(uint32_t, modules, wfAllModules(), "what the scene requires",
           .kind = WF_SETTING_SET, .rows = wfModuleTable, .rowSize = sizeof *wfModuleTable,
           .rowCount = &wfModuleCount, .most = UINT32_MAX, .builtIn = 1)
WF_SETTING(int32_t, forceCapacity, 64, "registered forces at most", WF_COUNTED,
           WF_CAPACITY(0), .modules = WF_MODULE_FORCES)
WF_SETTING(int32_t, shapeCapacity, 0, "shapes at most; 0: as many as bodies",
           WF_COUNTED, WF_CAPACITY(0), .modules = WF_MODULE_SHAPES)
WF_ADVANCED(int32_t, pairCapacity, 0,
            "pairs in one step; 0: 16 a shape, or all there can be", WF_COUNTED,
            WF_CAPACITY(0), .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(int32_t, contactCapacity, 0, "contacts in one step; 0: as many as pairs",
            WF_COUNTED, WF_CAPACITY(0), .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(int32_t, broadPhase, row_or_first(wfFindBroadPhase("dynamic-tree")),
            "finds pairs", WF_ROW(BroadPhase), .method = 1,
            .modules = WF_MODULE_CONTACTS | WF_MODULE_QUERIES)
WF_ADVANCED(int32_t, narrowPhase, wfFindNarrowPhase("sat"), "separates shapes",
            WF_ROW(NarrowPhase), .modules = WF_MODULE_CONTACTS | WF_MODULE_QUERIES)
WF_SETTING(int32_t, solver, row_or_first(wfFindSolver("soft")), "mends contacts",
           WF_ROW(Solver), .law = 1, .method = 1,
           .modules = WF_MODULE_CONTACTS | WF_MODULE_SUBSTEPS)
WF_SETTING(int32_t, iterations, 0,
           "passes of the contact solver; 0: as many as it wants", WF_COUNTED,
           WF_FROM(0), .law = 1, .modules = WF_MODULE_CONTACTS | WF_MODULE_SUBSTEPS)
WF_SETTING(int32_t, substeps, 4, "of solvers that step by themselves", WF_COUNTED,
           WF_FROM(1), .law = 1, .modules = WF_MODULE_CONTACTS | WF_MODULE_SUBSTEPS)
WF_ADVANCED(wfReal, restitutionThreshold, 2, "approaches slower than so many rest", WF_REAL,
            WF_FROM(0), .law = 1, .unit = "steps of gravity", .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(wfReal, positionCorrection, WF_R(0.4), "removed in a step", WF_REAL,
            WF_BETWEEN(0, 1), .law = 1, .unit = "of the overlap",
            .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(wfReal, slop, WF_R(0.005), "overlap that is left alone", WF_REAL, WF_FROM(0),
            .law = 1, .unit = "of the smaller reach", .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(int32_t, reuseManifolds, 1, "contacts of pairs that hardly moved are kept",
            WF_SWITCH, .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(wfReal, contactPeriod, WF_CONTACT_PERIOD, "period of a contact's spring",
            WF_REAL, WF_ABOVE(0), .law = 1, .unit = "substeps",
            .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(wfReal, contactDampingRatio, WF_CONTACT_DAMPING_RATIO,
            "damping ratio of a contact's spring", WF_REAL, WF_ABOVE(0), .law = 1,
            .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(wfReal, contactPushSpeed, 24,
            "overlap is left no faster than that; 0 or no gravity: no limit", WF_REAL,
            WF_FROM(0), .law = 1, .unit = "steps of gravity", .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(int32_t, graphColouring, 1, "contacts are solved by colours", WF_SWITCH,
            .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(int32_t, enableSimd, 1, "and several at once, to the same bits", WF_SWITCH,
            .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(int32_t, stackSolver, 3,
            "1: towers are solved at once; 1 + n: with up to n loops", WF_COUNTED,
            WF_BETWEEN(0, 1 + WF_STACK_LOOPS), .law = 1, .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(wfReal, stackSag, 3,
            "springs that give no more need no such solver; 0: all do", WF_REAL,
            WF_FROM(0), .law = 1, .unit = "slops", .modules = WF_MODULE_CONTACTS)
WF_SETTING(int32_t, frictionRule, wfFindMix("geometric-mean"), "of two shapes' friction",
           WF_ROW(Mix), .law = 1, .modules = WF_MODULE_FRICTION)
WF_SETTING(int32_t, restitutionRule, wfFindMix("maximum"), "of their restitution",
           WF_ROW(Mix), .law = 1, .modules = WF_MODULE_RESTITUTION)
WF_ADVANCED(int32_t, rollingRule, wfFindMix("maximum"), "of their rolling resistance",
            WF_ROW(Mix), .law = 1, .modules = WF_MODULE_ROLLING)
WF_SETTING(int32_t, events, 1, "touches are remembered; told, if needed", WF_SWITCH,
           .builtIn = 1, .modules = WF_MODULE_CONTACTS)
WF_ADVANCED(wfReal, hitThreshold, 6, "approaches faster than so many are hits", WF_REAL,
            WF_FROM(0), .unit = "steps of gravity", .modules = WF_MODULE_EVENTS)
WF_ADVANCED(int32_t, queries, 1, "queries are quick after every step", WF_SWITCH,
            .modules = WF_MODULE_QUERIES)
WF_ADVANCED(int32_t, materialPairCapacity, 16, "pairs of materials that may be known",
            WF_COUNTED, WF_CAPACITY(0), .modules = WF_MODULE_MATERIALS)
WF_ADVANCED(int32_t, compensatedSums, 0,
            "what states round away is kept, by the solver soft",
            WF_SWITCH, .builtIn = 1, .law = 1)
WF_SETTING(int32_t, jointCapacity, 64, "joints at most", WF_COUNTED, WF_CAPACITY(0),
           .modules = WF_MODULE_JOINTS)
WF_ADVANCED(int32_t, directJoints, WF_JOINTS_AUTO, "joints solved together",
            WF_CHOICE(wfExactNames), .modules = WF_MODULE_JOINTS)
WF_ADVANCED(wfReal, directJointCost, WF_EXACT_CHEAP,
            "AUTO: products of blocks a joint, at most", WF_REAL, WF_FROM(0),
            .modules = WF_MODULE_JOINTS)
WF_ADVANCED(wfReal, jointCompliance, WF_JOINT_COMPLIANCE,
            "how much joints solved together give",
            WF_REAL, WF_FROM(0), .modules = WF_MODULE_JOINTS)
WF_SETTING(int32_t, maxImpacts, 4096,
           "impacts of a fast body in a step, at most; 0: none is looked for",
           WF_COUNTED, WF_BETWEEN(0, WF_MAX_CAPACITY), .modules = WF_MODULE_FAST)
WF_SETTING(int32_t, sleep, 0, "islands that rest are left out of the step", WF_SWITCH,
           .modules = WF_MODULE_SLEEP)
WF_ADVANCED(wfReal, timeToSleep, WF_R(0.5),
            "for so long all of an island must have been still", WF_REAL, WF_ABOVE(0),
            .unit = "s", .modules = WF_MODULE_SLEEP)
WF_ADVANCED(wfReal, sleepThreshold, WF_R(0.04),
            "still is who goes less of its reach in that time", WF_REAL, WF_FROM(0),
            .unit = "of the reach", .modules = WF_MODULE_SLEEP)
#undef WF_SETTING
#undef WF_ADVANCED
