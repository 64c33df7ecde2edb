/* Weft: testbed/scene_table.c, tangled from chapters/testbed/11-first-scenes.nw. Chapters that add
 * to it: report-scenes, feature-scenes, classics, asked-scenes, driven-scenes, challenges. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
/* All scenes, by file, in the order of the list. */
#include "testbed/scene.h"

#define GROUP(name) extern const wfSceneGroup name;
/* groups of scenes */
GROUP(wfMotionScenes)
GROUP(wfForceScenes)
GROUP(wfCollisionScenes)
GROUP(wfCaseScenes)
GROUP(wfPerformanceScenes)
GROUP(wfShapeScenes)
GROUP(wfEventScenes)
GROUP(wfJointScenes)
GROUP(wfSleepScenes)
GROUP(wfFastScenes)
GROUP(wfClassicScenes)
GROUP(wfAskedScenes)
GROUP(wfLastScenes)
GROUP(wfDrivenScenes)
GROUP(wfTableScenes)
GROUP(wfMachineScenes)
GROUP(wfSoftScenes)
GROUP(wfChallengeScenes)
#undef GROUP
#define GROUP(name) &name,
static const wfSceneGroup *const group_table[] = {
    /* groups of scenes */
    GROUP(wfMotionScenes)
    GROUP(wfForceScenes)
    GROUP(wfCollisionScenes)
    GROUP(wfCaseScenes)
    GROUP(wfPerformanceScenes)
    GROUP(wfShapeScenes)
    GROUP(wfEventScenes)
    GROUP(wfJointScenes)
    GROUP(wfSleepScenes)
    GROUP(wfFastScenes)
    GROUP(wfClassicScenes)
    GROUP(wfAskedScenes)
    GROUP(wfLastScenes)
    GROUP(wfDrivenScenes)
    GROUP(wfTableScenes)
    GROUP(wfMachineScenes)
    GROUP(wfSoftScenes)
    GROUP(wfChallengeScenes)
};
enum { GROUPS = sizeof group_table / sizeof *group_table };
const wfSceneGroup *wfBroughtScenes;

int wfSceneCount(void)
{
    size_t count = 0;
    for (int i = 0; i < GROUPS; i++) count += group_table[i]->count;
    if (wfBroughtScenes) count += wfBroughtScenes->count;
    return (int)count;
}

const wfScene *wfSceneAt(int row)
{
    for (int i = 0; i < GROUPS && row >= 0; i++) {
        if ((size_t)row < group_table[i]->count) return &group_table[i]->scene[row];
        row -= (int)group_table[i]->count;
    }
    if (wfBroughtScenes && row >= 0 && (size_t)row < wfBroughtScenes->count)
        return &wfBroughtScenes->scene[row];
    return NULL;
}
