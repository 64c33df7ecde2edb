/* Weft: figures/kit.h, tangled from chapters/engine/04-design.nw. Chapters that add to it:
 * memory.figures, shapes.figures, integration.figures, narrow-phase.figures, sequential.figures. Do
 * not edit this file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_FIGURES_KIT_H
#define WEFT_FIGURES_KIT_H
/* What figures share, and how a chapter adds its own. Source. */
#include "lab/lab.h"
#include "weft/shape.h"
#include "weft/force.h"
#include "weft/integrate.h"

/* figures/NAME.c ends with   const wfFigureSet NAME_figures = WF_ROWS(rows);   */
#define CHAPTER(name) extern const wfFigureSet name##_figures;
#include "figures/list.h"
#undef CHAPTER

/* An upright rectangle from (x0, y0) to (x1, y1). */
void figRect(wfDraw *d, float x0, float y0, float x1, float y1, float widthPx, int line,
             int fill);
void figBox(wfDraw *d, float x, float y, float w, float h, int role,
            const char *title, const char *below);
void figBar(wfDraw *d, float x, float y, float w, float h, int fill);
void figRing(wfDraw *d, const wfVec2 *ring, int count, float widthPx, int line,
             int fill);
void figShape(wfDraw *d, const wfShape *s, wfTransform at, float widthPx,
              int line, int fill);
wfVec2 figHandle(const wfFigureInput *in, int i);
/* Moves a body under one force by so many steps of h; its places go to xy, unless that is
   NULL. Returns the number of places. */
int figPath(const char *method, wfBodyState *body, wfForce *force, double h,
            int steps, float *xy);
/* 2 to the power u, 0 <= u <= 8: whole powers, and between them by 2^(1/2), 2^(1/4) ... */
wfReal figTwoTo(wfReal u);
/* The line with the handle; returns its place, 0 at the left end to 1 at the right. */
wfReal figSlider(wfDraw *d, const wfFigureInput *in, const char *left,
                 const char *right);
wfReal figStepSlider(wfDraw *d, const wfFigureInput *in);
void figSegment(wfDraw *d, wfVec2 from, wfVec2 to, float widthPx, int role);
/* Did the engine do it? If not, the program that draws the figures is told. */
bool figAccept(wfDraw *d, wfResult result);
#endif
