// Which quad touches which texel.
layout(std430, binding = 11) buffer BeamTouches {
    uvec3 touchGroups; // to dispatch: 64 touches each
    int touchesAsked;  // of which those that did not fit are not in it
    ivec2 touchCount;  // x: in it
    ivec2 touches[];   // quad; texel, row by row
};

// Where so many touches may go, < 0 for nowhere.
int reserveTouches(int count) {
    int first = atomicAdd(touchesAsked, count), end = first + count;
    if (first < 0 || end < 0 || end > touches.length()) return -1;
    atomicMax(touchCount.x, end);
    atomicMax(touchGroups.x, uint(min((end + 63) / 64, 65535)));
    return first;
}
