/* Weft: collision/links.h, tangled from chapters/methods/08-rounded-contacts.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* links.h: contacts of a link.  Not installed. */
#ifndef WEFT_COLLISION_LINKS_H
#define WEFT_COLLISION_LINKS_H
#include "collision/clip.h"

/* The contacts of a link, A or B, with what is in front of it; sets out->normal. */
void wfLinkContacts(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb,
                    wfReal margin, wfManifold *out);
#endif
