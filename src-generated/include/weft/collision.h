/* Weft: include/weft/collision.h, tangled from chapters/engine/19-events-and-queries.nw. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
/* collision.h: the whole component `collision`, for users of libweft-collision alone. */
#ifndef WEFT_COLLISION_H
#define WEFT_COLLISION_H
#include "weft/core.h"
#include "weft/math.h"
#include "weft/shape.h"
#include "weft/broad.h"
#include "weft/narrow.h"
#include "weft/contact.h"
#include "weft/compound.h"
#include "weft/impact.h"
#include "weft/query.h"
#include "weft/events.h"
#endif
