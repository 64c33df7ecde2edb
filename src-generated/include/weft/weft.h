/* Weft: include/weft/weft.h, tangled from chapters/engine/20-world.nw. Chapters that add to it:
 * looking, sensors-and-callbacks, mouse-joint, world-origin, save-and-replay, tolerance. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_WEFT_H
#define WEFT_WEFT_H
/* All of the engine. */
#include "weft/world.h"
#include "weft/inspect.h"
#include "weft/modules.h"
#include "weft/settings.h"
#include "weft/material.h"
#include "weft/callbacks.h"
#include "weft/mouse.h"
#include "weft/origin.h"
#include "weft/save.h"
#include "weft/accuracy.h"
#endif
