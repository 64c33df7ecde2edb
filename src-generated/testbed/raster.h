/* Weft: testbed/raster.h, tangled from chapters/testbed/03-drawing-pixels.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_RASTER_H
#define WEFT_RASTER_H
/* A display list as pixels. Source. */
#include "testbed/canvas.h"
#include "testbed/font.h"
#include "testbed/platform.h"

/* a row of coverage */
#define WF_COVER_WIDTH 1024
/* What share of each pixel of a piece of row y is covered: at[i] is pixel x0 + i. */
typedef struct wfCoverRow {
    int32_t y, x0, width;             /* width <= WF_COVER_WIDTH */
    int32_t low, high;                /* only at[low] to at[high - 1] may differ from 0 */
    int32_t fullLow, fullHigh;        /* at[fullLow] to at[fullHigh - 1] are surely 1 */
    float   at[WF_COVER_WIDTH + 2];
} wfCoverRow;
void wfCoverBegin(wfCoverRow *row, int32_t y, int32_t x0, int32_t width);
void wfCoverClear(wfCoverRow *row);
/* The inside of a polygon, exact; xy in world units, brought to pixels by the map. */
void wfCoverPolygon(wfCoverRow *row, wfPixelMap map, const float *xy, int count);
/* A line with round ends, a disc, a ring; pixels. The greater coverage stays. */
void wfCoverLine(wfCoverRow *row, const float from[2], const float to[2], float half);
void wfCoverDisc(wfCoverRow *row, float x, float y, float radius);
void wfCoverRing(wfCoverRow *row, float x, float y, float radius, float half);
/* Fills the whole picture with one opaque ink. */
void wfClearFrame(frame_buffer *target, wfInk ink);
/* Draws the list over what is there, the view as large as fits, in the middle.
 * Without a font (NULL) text is left out. Nothing outside the picture is touched. */
void wfRenderList(const wfDraw *list, const wfFont *font, const wfPalette *palette,
                  frame_buffer *target);
/* The same picture, its rows shared by threads. */
void wfRenderShared(const wfDraw *list, const wfFont *font, const wfPalette *palette,
                    frame_buffer *target, wfWorkers by);
/* Where the list's view lies in the picture: for the mouse. */
wfPixelMap wfFrameMap(const float view[4], const frame_buffer *target);
/* The ink laid over a pixel's bytes r, g, b, a, covering a share 0..1 of its light. */
void wfBlend(uint8_t pixel[4], wfInk ink, float share);
/* The same for letters: shares of the bytes, as fonts expect. */
void wfBlendLetter(uint8_t pixel[4], wfInk ink, float share);
#endif
