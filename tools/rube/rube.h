/* rube.h: scenes of R.U.B.E., translated. MIT licence. */
#ifndef RUBE_H
#define RUBE_H
#include "weft/json.h"

/* Translates a R.U.B.E. scene (Box2D) into a text that wfReadScene reads; free *out by
 * wfFreeText. WF_ERROR_TEXT: not such a scene, or something in it that would move otherwise
 * here; _MEMORY, _NULL; what wfReadScene finds. error may be NULL. */
wfResult wfTranslateRube(const char *text, size_t length, char **out, wfTextError *error);
#endif
