// CIE 171:2006, test case 5.2: the light of a point source 3 m over a floor, as it is published.
#pragma once

namespace fiatlux {

inline constexpr int kCie171Points = 10;
/// x and y on the floor from the point below the source, m.
inline constexpr double kCie171Places[kCie171Points][2] = {{0, 0},  {.5, 0},   {1, 0}, {1.5, 0}, {.5, .5},
                                                           {1, .5}, {1.5, .5}, {1, 1}, {1.5, 1}, {1.5, 1.5}};
/// lx there, of 1000 cd straight down as from a Lambertian point, and of 1000 cd in every direction.
inline constexpr double kCie171Lambertian[kCie171Points] = {111.111, 105.186, 90.000, 71.111, 99.723,
                                                            85.663,  68.053,  74.380, 59.975, 49.383};
inline constexpr double kCie171Isotropic[kCie171Points] = {111.111, 106.637, 94.868, 79.505, 102.456,
                                                           91.419,  76.926,  82.230, 69.971, 60.481};

}  // namespace fiatlux
