// Room in the list of touches.
#include "interface/beam_touches.glsl"

// Where so many touches may go, < 0 for nowhere.
int reserveTouches(int count) {
    int first = atomicAdd(touchesAsked, count), end = first + count;
    if (first < 0 || end < 0 || end > touches.length()) return -1;
    atomicMax(touchCount.x, end);
    atomicMax(touchGroups.x, uint(min((end + 63) / 64, 65535)));
    return first;
}
