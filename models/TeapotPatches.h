#pragma once

#include <array>

/// The Utah teapot, as Martin Newell measured it in 1975: 32 bicubic Bézier patches over 306 control points,
/// published in F. Crow, "The Origins of the Teapot", IEEE Computer Graphics and Applications 7(1), 1987,
/// with the bottom that was added to it there. Newell's units, z up, the teapot standing on z = 0.
///
/// Every number of that table is here once: the pot, lid and bottom repeat one quarter four times around z,
/// the handle and spout repeat one half across y = 0. 6 · 4 + 4 · 2 = 32. The top of the lid is one point, as
/// in Crow's table; older copies of the data spread it over 0.002.
namespace limpid::models {

/// One row of four control points of a patch that goes a quarter around: (r, 0, z), (r, −k, z), (k, −r, z),
/// (0, −r, z). A circle would have k = 0.5523 r; Newell took 0.56.
struct QuarterRow {
    double r, k, z;
};

/// Rows from the top of the teapot downward along its profile.
inline constexpr std::array<std::array<QuarterRow, 4>, 6> quarterPatches{{
    // rim
    {{{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125}, {1.5, 0.84, 2.4}}},
    // body
    {{{1.5, 0.84, 2.4}, {1.75, 0.98, 1.875}, {2.0, 1.12, 1.35}, {2.0, 1.12, 0.9}}},
    {{{2.0, 1.12, 0.9}, {2.0, 1.12, 0.45}, {1.5, 0.84, 0.225}, {1.5, 0.84, 0.15}}},
    // lid
    {{{0.0, 0.0, 3.15}, {0.8, 0.45, 3.15}, {0.0, 0.0, 2.85}, {0.2, 0.112, 2.7}}},
    {{{0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}}},
    // bottom
    {{{1.5, 0.84, 0.15}, {1.5, 0.84, 0.075}, {1.425, 0.798, 0.0}, {0.0, 0.0, 0.0}}},
}};

struct ControlPoint {
    double x, y, z;
};

/// Rows along the handle or spout, each half around it on the side of negative y.
inline constexpr std::array<std::array<std::array<ControlPoint, 4>, 4>, 4> halfPatches{{
    // handle
    {{{{{-1.6, 0.0, 2.025}, {-1.6, -0.3, 2.025}, {-1.5, -0.3, 2.25}, {-1.5, 0.0, 2.25}}},
      {{{-2.3, 0.0, 2.025}, {-2.3, -0.3, 2.025}, {-2.5, -0.3, 2.25}, {-2.5, 0.0, 2.25}}},
      {{{-2.7, 0.0, 2.025}, {-2.7, -0.3, 2.025}, {-3.0, -0.3, 2.25}, {-3.0, 0.0, 2.25}}},
      {{{-2.7, 0.0, 1.8}, {-2.7, -0.3, 1.8}, {-3.0, -0.3, 1.8}, {-3.0, 0.0, 1.8}}}}},
    {{{{{-2.7, 0.0, 1.8}, {-2.7, -0.3, 1.8}, {-3.0, -0.3, 1.8}, {-3.0, 0.0, 1.8}}},
      {{{-2.7, 0.0, 1.575}, {-2.7, -0.3, 1.575}, {-3.0, -0.3, 1.35}, {-3.0, 0.0, 1.35}}},
      {{{-2.5, 0.0, 1.125}, {-2.5, -0.3, 1.125}, {-2.65, -0.3, 0.9375}, {-2.65, 0.0, 0.9375}}},
      {{{-2.0, 0.0, 0.9}, {-2.0, -0.3, 0.9}, {-1.9, -0.3, 0.6}, {-1.9, 0.0, 0.6}}}}},
    // spout
    {{{{{1.7, 0.0, 1.425}, {1.7, -0.66, 1.425}, {1.7, -0.66, 0.6}, {1.7, 0.0, 0.6}}},
      {{{2.6, 0.0, 1.425}, {2.6, -0.66, 1.425}, {3.1, -0.66, 0.825}, {3.1, 0.0, 0.825}}},
      {{{2.3, 0.0, 2.1}, {2.3, -0.25, 2.1}, {2.4, -0.25, 2.025}, {2.4, 0.0, 2.025}}},
      {{{2.7, 0.0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0.0, 2.4}}}}},
    {{{{{2.7, 0.0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0.0, 2.4}}},
      {{{2.8, 0.0, 2.475}, {2.8, -0.25, 2.475}, {3.525, -0.25, 2.49375}, {3.525, 0.0, 2.49375}}},
      {{{2.9, 0.0, 2.475}, {2.9, -0.15, 2.475}, {3.45, -0.15, 2.5125}, {3.45, 0.0, 2.5125}}},
      {{{2.8, 0.0, 2.4}, {2.8, -0.15, 2.4}, {3.2, -0.15, 2.4}, {3.2, 0.0, 2.4}}}}},
}};

} // namespace limpid::models
