/* What a user of the installed library weft-json writes: a scene as text, and the text of the world it makes. */
#include <stdio.h>
#include <string.h>
#include <weft/json.h>

int main(void)
{
    const char *scene = "{ \"weft\": 1, \"bodies\": [ { \"position\": [0, 100], \"shapes\": [ { \"kind\": \"circle\", \"radius\": 0.5 } ] } ] }";
    wfWorld world;
    wfTextError e;
    char *text;
    if (wfReadScene(scene, strlen(scene), NULL, &world, NULL, &e) != WF_OK) {
        fprintf(stderr, "line %d: %s: %s\n", (int)e.line, e.where, e.what);
        return 1;
    }
    if (wfStepWorld(&world) != WF_OK || wfWriteScene(&world, NULL, &text) != WF_OK) return 2;
    printf("a scene of one ball is %zu bytes of text\n", strlen(text));
    wfFreeText(text);
    wfDestroyWorld(&world);
    return 0;
}
