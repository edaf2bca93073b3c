// Triangles of a mesh against the tets of a shell: what the contact part of claim C3+ `i2` is about.
#pragma once
#include <set>

#include "dot.hpp"
#include "geometry.hpp"
#include "tets.hpp"

// A tet of a prism: its points and the ends of its pillar half.
struct Solid {
  std::array<Row, 4> corners;
  Row lo, hi;
};

template <class Kernel>
typename Kernel::Tetrahedron_3 tetrahedron(const Solid& tet) {
  const auto& x = tet.corners;
  return {point<Kernel>(x[0]), point<Kernel>(x[1]), point<Kernel>(x[2]), point<Kernel>(x[3])};
}

// The different tets of a prism; those on a pinched pillar are left out.
inline std::vector<Solid> prism_solids(const Shell& shell, const Face& face) {
  static const std::vector<LocalTet> local = prism_tets();
  std::vector<Solid> out;
  const std::array<bool, 3> flat{shell.pinched(face[0]), shell.pinched(face[1]), shell.pinched(face[2])};
  std::set<std::array<std::pair<std::size_t, int>, 4>> seen;
  for (const LocalTet& tet : local) {
    if (vanishes(tet, flat)) continue;
    Solid solid;
    std::array<std::pair<std::size_t, int>, 4> names;
    for (int i = 0; i < 4; ++i) {
      const std::size_t v = face[tet[i].corner];
      names[i] = {v, shell.pinched(v) ? 1 : tet[i].layer};
      solid.corners[i] = shell.layers[tet[i].layer][v];
      for (int j = 0; j < i; ++j) {
        if (tet[i].corner != tet[j].corner) continue;
        const auto [low, high] = std::minmax(tet[i].layer, tet[j].layer);
        solid.lo = shell.layers[low][v];
        solid.hi = shell.layers[high][v];
      }
    }
    std::sort(names.begin(), names.end());
    if (seen.insert(names).second) out.push_back(solid);
  }
  return out;
}

inline std::set<Row> pinched_points(const Shell& shell) {
  std::set<Row> out;
  for (std::size_t v = 0; v < shell.layers[1].size(); ++v)
    if (shell.pinched(v)) out.insert(shell.layers[1][v]);
  return out;
}

// Do the triangle and the tet share nothing but one pinched vertex of the tet?
inline bool only_pinched(const Mesh& mesh, std::size_t f, const Solid& tet, const std::set<Row>& pinched) {
  if (std::none_of(tet.corners.begin(), tet.corners.end(), [&](const Row& x) { return pinched.count(x) > 0; }))
    return false;
  const auto common = CGAL::intersection(triangle<Exact>(mesh.points, mesh.faces[f]), tetrahedron<Exact>(tet));
  const auto* at = common ? boost::get<Exact::Point_3>(&*common) : nullptr;
  if (!at) return false;
  return std::any_of(tet.corners.begin(), tet.corners.end(),
                     [&](const Row& x) { return pinched.count(x) > 0 && point<Exact>(x) == *at; });
}

inline std::vector<Box> prism_boxes(const Shell& shell, const std::vector<std::size_t>& ids) {
  std::vector<Box> out;
  out.reserve(shell.faces.size());
  for (std::size_t i = 0; i < shell.faces.size(); ++i) {
    CGAL::Bbox_3 box;
    for (const auto& layer : shell.layers) box += triangle<Fast>(layer, shell.faces[i]).bbox();
    out.emplace_back(box, &ids[i]);
  }
  return out;
}

// Pairs of a mesh triangle and a tet that share a point other than a pinched vertex although the triangle's dot with the
// tet's pillar half is not positive. By boxes of prisms; a prism whose six dots are positive needs none of its tets.
inline std::size_t contacts_by_prisms(const Mesh& mesh, const Shell& shell) {
  const auto pinched = pinched_points(shell);
  const auto mesh_ids = ids_of(mesh.faces.size()), shell_ids = ids_of(shell.faces.size());
  auto triangles = triangle_boxes(mesh.points, mesh.faces, mesh_ids);
  auto prisms = prism_boxes(shell, shell_ids);
  std::size_t contacts = 0;
  const DotOf<Fast>::type dot;
  CGAL::box_intersection_d(triangles.begin(), triangles.end(), prisms.begin(), prisms.end(), [&](const Box& a, const Box& b) {
    const std::size_t f = *a.handle();
    const Face& prism = shell.faces[*b.handle()];
    const auto face = triangle<Fast>(mesh.points, mesh.faces[f]);
    const auto positive = [&](const Row& lo, const Row& hi) {
      return dot(face[0], face[1], face[2], point<Fast>(lo), point<Fast>(hi)) == CGAL::POSITIVE;
    };
    bool all = true;
    for (const std::size_t v : prism)
      for (int slab = 0; slab < 2; ++slab)
        all = all && (shell.pinched(v) || positive(shell.layers[slab][v], shell.layers[slab + 1][v]));
    if (all) return;
    for (const Solid& tet : prism_solids(shell, prism))
      if (!positive(tet.lo, tet.hi) && CGAL::do_intersect(face, tetrahedron<Fast>(tet)) && !only_pinched(mesh, f, tet, pinched))
        ++contacts;
  });
  return contacts;
}
