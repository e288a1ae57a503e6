// A run of a box that holds surface (thesis eq. 4-21), with reference planes of its own.
#pragma once
struct SubBox {
    float top;    // depth where it begins, m
    float height; // m
    int firstPlane;
    int planeCount;
};
