// A vertex of a receiver in words: position and normal, three each; two pairs of texture coordinates; colour, two words.
#pragma once
const int vertexWords = 12;
