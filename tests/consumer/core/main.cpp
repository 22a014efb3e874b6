#include <cmath>
#include <cstdio>

#include <scree/mesh/convex_hull.hpp>
#include <scree/mesh/mass_properties.hpp>
#include <scree/version.hpp>

// Uses the part of the library that needs Eigen only, as a program outside the project does.
int main() {
    const scree::ConvexHull hull = scree::convex_hull(scree::make_box({1, 2, 3}).vertices);
    const double volume = scree::mass_properties(hull.solid).volume;
    std::printf("scree %s: a box of %g m3 with %d faces\n", scree::version, volume, hull.solid.face_count());
    return hull.solid.face_count() == 6 && std::abs(volume - 6) < 1e-14 ? 0 : 1;
}
