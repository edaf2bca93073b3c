// The tets of a prism, derived from the definition: six orders of three corners, three tets each, in two slabs.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "off.hpp"

// A point of a prism: corner 0..2, layer 0 bottom, 1 middle, 2 top.
struct Local {
  int corner, layer;
  bool operator<(const Local& o) const { return std::pair(corner, layer) < std::pair(o.corner, o.layer); }
  bool operator==(const Local& o) const { return corner == o.corner && layer == o.layer; }
};
using LocalTet = std::array<Local, 4>;

// Is the tet positive in the straight unit prism?
inline bool positive_in_unit_prism(const LocalTet& tet) {
  const int at[3][2] = {{0, 0}, {1, 0}, {0, 1}};
  int m[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 2; ++k) m[i][k] = at[tet[i + 1].corner][k] - at[tet[0].corner][k];
    m[i][2] = tet[i + 1].layer - tet[0].layer;
  }
  const int det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                  m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                  m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  if (det == 0) refuse("internal: a flat tet in the unit prism");
  return det > 0;
}

// The 24 tets of a prism, oriented.
inline std::vector<LocalTet> prism_tets() {
  std::set<LocalTet> seen;
  std::vector<LocalTet> out;
  for (int lo = 0; lo < 2; ++lo) {
    std::array<int, 3> order{0, 1, 2};
    do {
      const auto [u, v, w] = order;
      const int hi = lo + 1;
      const LocalTet tets[3] = {{{{u, lo}, {v, lo}, {w, lo}, {w, hi}}},
                                {{{u, lo}, {v, lo}, {v, hi}, {w, hi}}},
                                {{{u, lo}, {u, hi}, {v, hi}, {w, hi}}}};
      for (LocalTet tet : tets) {
        std::sort(tet.begin(), tet.end());
        if (!seen.insert(tet).second) continue;
        if (!positive_in_unit_prism(tet)) std::swap(tet[2], tet[3]);
        out.push_back(tet);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  if (out.size() != 24) refuse("internal: not 24 tets");
  return out;
}

// Does the tet hold two points of the pillar of a pinched corner (and so vanish)?
inline bool vanishes(const LocalTet& tet, const std::array<bool, 3>& pinched) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      if (tet[i].corner == tet[j].corner && pinched[tet[i].corner]) return true;
  return false;
}
