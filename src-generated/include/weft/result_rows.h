/* Weft: include/weft/result_rows.h, tangled from chapters/engine/05-memory.nw. Chapters that add to
 * it: numbers, shapes, implicit-midpoint, compound, world, joints-in-a-world, continuous-collision,
 * sleep-in-a-world, save-and-replay, replay, save-files, scenes-as-text, accuracy. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* No include guard: core.h and memory.c both read this, each with its own WF_RESULT. */
WF_RESULT(WF_OK, "all is well")
WF_RESULT(WF_ERROR_NULL, "a pointer is NULL: pass the address of a structure")
WF_RESULT(WF_ERROR_NOT_FINITE,
          "a number is NaN or infinite: look for a division by zero before the call")
WF_RESULT(WF_ERROR_RANGE,
          "a number is outside its allowed range: the function's comment states it")
WF_RESULT(WF_ERROR_FULL, "a pool or a list is full: ask for more capacity at creation")
WF_RESULT(WF_ERROR_MEMORY,
          "memory is missing, too small or misaligned: see wfPoolInit, wfAllocateMemory")
WF_RESULT(WF_ERROR_STALE_ID, "an id names something that was removed or never existed")
WF_RESULT(WF_ERROR_UNKNOWN, "a table has no such row: look it up with its wfFind function")
WF_RESULT(WF_ERROR_BUILD,
          "other bits: compile with -ffp-contract=off -fno-tree-vectorize, not fast-math")
WF_RESULT(WF_ERROR_TOO_FEW,    "a polygon needs at least three points: pass more")
WF_RESULT(WF_ERROR_TOO_MANY,
          "the hull has more than WF_MAX_VERTICES corners: leave some points out")
WF_RESULT(WF_ERROR_DEGENERATE,
          "points on a line or in one place, or nearly: move them apart, or drop some")
WF_RESULT(WF_ERROR_COAT,
          "radius and core differ too much to see both: take a bare shape, or a circle")
WF_RESULT(WF_ERROR_SIZE,
          "a shape is under WF_MIN_SIZE or reaches past WF_MAX_SIZE: use other units")
WF_RESULT(WF_ERROR_NOT_CONVEX,
          "corners, normals and centroid are no convex shape's: use wfMakePolygon")
WF_RESULT(WF_ERROR_MASS,
          "a mass or an inertia is out of range: see WF_MIN_MASS and its neighbours")
WF_RESULT(WF_ERROR_NO_CONVERGENCE,
          "an implicit step found no solution: use a shorter step or softer forces")
WF_RESULT(WF_ERROR_DUPLICATE,
          "a corner of the outline comes twice: leave one out, or use wfTidyOutline")
WF_RESULT(WF_ERROR_FLAT,
          "a corner lies on the line of its neighbours: drop it, or use wfTidyOutline")
WF_RESULT(WF_ERROR_CROSSES,
          "two sides of the outline cross or touch: wfCheckOutline says which")
WF_RESULT(WF_ERROR_THIN,
          "a part of the outline is too thin for a shape: thicken it or cut it off")
WF_RESULT(WF_ERROR_BUILT_IN,
          "this setting is built into the block: create a world with it (wfGetWorldDef)")
WF_RESULT(WF_ERROR_NOT_A_WORLD,
          "these bytes are no world of this build: create one, or open a copy of one")
WF_RESULT(WF_ERROR_BUSY,
          "a step is under way: hooks may look, but change nothing; do it after the step")
WF_RESULT(WF_ERROR_NO_ROTATION,
          "this world was made without rotation: add WF_NEED_ROTATION")
WF_RESULT(WF_ERROR_NO_DAMPING,
          "this world was made without damping: add WF_NEED_DAMPING")
WF_RESULT(WF_ERROR_NO_PUSHES,
          "this world was made without pushes: add WF_NEED_PUSHES")
WF_RESULT(WF_ERROR_NO_FORCES,
          "this world was made without forces: add WF_NEED_FORCES")
WF_RESULT(WF_ERROR_NO_SHAPES,
          "this world was made without shapes: add WF_NEED_SHAPES")
WF_RESULT(WF_ERROR_NO_CONTACTS,
          "this world was made without contacts: add WF_NEED_CONTACTS")
WF_RESULT(WF_ERROR_NO_FRICTION,
          "this world was made without friction: add WF_NEED_FRICTION")
WF_RESULT(WF_ERROR_NO_RESTITUTION,
          "this world was made without restitution: add WF_NEED_RESTITUTION")
WF_RESULT(WF_ERROR_NO_ROLLING,
          "this world was made without rolling resistance: add WF_NEED_ROLLING")
WF_RESULT(WF_ERROR_NO_MATERIALS,
          "this world was made without pairs of materials: add WF_NEED_MATERIALS")
WF_RESULT(WF_ERROR_NO_COMPOUNDS,
          "this world was made without bodies of several shapes: add WF_NEED_COMPOUNDS")
WF_RESULT(WF_ERROR_NO_EVENTS,
          "this world was made without events: add WF_NEED_EVENTS")
WF_RESULT(WF_ERROR_NO_SENSORS,
          "this world was made without sensors: add WF_NEED_SENSORS")
WF_RESULT(WF_ERROR_NO_HOOKS,
          "this world was made without hooks: add WF_NEED_HOOKS")
WF_RESULT(WF_ERROR_NO_QUERIES,
          "this world was made without queries: add WF_NEED_QUERIES")
WF_RESULT(WF_ERROR_NO_SUBSTEPS,
          "this world was made without substeps of a solver: add WF_NEED_SUBSTEPS")
WF_RESULT(WF_ERROR_NO_METHODS,
          "this world was made without room for other methods: add WF_NEED_METHODS")
WF_RESULT(WF_ERROR_NO_JOINTS,
          "this world was made without joints: add WF_NEED_JOINTS")
WF_RESULT(WF_ERROR_SOLVER,
          "this world's solver keeps contacts only: choose one that keeps joints, as soft")
WF_RESULT(WF_ERROR_NO_FAST,
          "this world was made without fast bodies: add WF_NEED_FAST")
WF_RESULT(WF_ERROR_NO_SLEEP,
          "this world was made without sleep: add WF_NEED_SLEEP")
WF_RESULT(WF_ERROR_DIFFERENT,
          "two worlds that were compared are not the same: wfDifference says where")
WF_RESULT(WF_ERROR_DIVERGED,
          "a replay has another hash than the recording: wfFindDivergence says where")
WF_RESULT(WF_ERROR_NOT_A_SAVE, "these bytes are no saved world: look for another file")
WF_RESULT(WF_ERROR_TRUNCATED,
          "there are fewer bytes than there should be, or more: copy the file again")
WF_RESULT(WF_ERROR_CHECKSUM,
          "the bytes were damaged since they were written: take an older copy")
WF_RESULT(WF_ERROR_VERSION,
          "saved in another version of the format: save it as text with its own program")
WF_RESULT(WF_ERROR_BYTE_ORDER,
          "saved on a machine with the other byte order: save it as text there")
WF_RESULT(WF_ERROR_PRECISION,
          "saved in the other precision, float or double: save it as text there")
WF_RESULT(WF_ERROR_LAYOUT,
          "saved by a build whose worlds look otherwise: save it as text with that one")
WF_RESULT(WF_ERROR_LIMIT,
          "it claims more memory than may be taken for it: allow more by wfLoadLimits")
WF_RESULT(WF_ERROR_FILE,
          "a file cannot be opened, read or written: see errno for the system's reason")
WF_RESULT(WF_ERROR_INVALID,
          "the world breaks its own rules: wfCheckWorld says which; load another")
WF_RESULT(WF_ERROR_TEXT,
          "the text is no scene: its wfTextError says what is wrong and where")
WF_RESULT(WF_ERROR_TOLERANCE,
          "nothing is so accurate here: allow more, or more digits (fineSums, WF_DOUBLE)")
WF_RESULT(WF_ERROR_BUDGET,
          "not even the cheapest setting fits: allow more time, or simplify the scene")
