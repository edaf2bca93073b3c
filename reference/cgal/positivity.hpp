// Claim C1 `positivity`: the signs of the 24 tets of every prism.
#pragma once
#include <CGAL/enum.h>

#include "tets.hpp"

struct Counts {
  std::size_t tets = 0, bad = 0;
};

// A shell in points of a kernel.
template <class Kernel>
struct PointShell {
  using Point = typename Kernel::Point_3;
  const std::vector<Face>& faces;
  std::array<std::vector<Point>, 3> points;
  std::vector<char> pinched;
  std::vector<LocalTet> tets = prism_tets();

  explicit PointShell(const Shell& shell) : faces(shell.faces) {
    for (int layer = 0; layer < 3; ++layer)
      for (const Row& row : shell.layers[layer]) points[layer].emplace_back(row[0], row[1], row[2]);
    for (std::size_t v = 0; v < shell.layers[0].size(); ++v) pinched.push_back(shell.pinched(v));
  }

  // Tets on a pinched pillar vanish and do not count.
  Counts positivity() const {
    Counts out;
    for (const Face& face : faces) {
      const std::array<bool, 3> flat{bool(pinched[face[0]]), bool(pinched[face[1]]), bool(pinched[face[2]])};
      const bool any = flat[0] || flat[1] || flat[2];
      for (const LocalTet& tet : tets) {
        if (any && vanishes(tet, flat)) continue;
        const auto at = [&](int i) -> const Point& { return points[tet[i].layer][face[tet[i].corner]]; };
        ++out.tets;
        if (CGAL::orientation(at(0), at(1), at(2), at(3)) != CGAL::POSITIVE) ++out.bad;
      }
    }
    return out;
  }
};
