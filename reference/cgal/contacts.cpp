// The contact part of claim C3+ `i2` with CGAL: triangles of the mesh against all tets of the shell.
//
//   contacts BOTTOM.off MIDDLE.off TOP.off MESH.off
//
// Prints one line of key=value. `contacts`: pairs of a mesh triangle and a different tet of a prism that share a point
// other than a pinched vertex, although the triangle's dot with the tet's pillar half is not positive. `touching`: pairs that
// share a point, whatever the dot.
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <numeric>
#include <set>

#include "dot.hpp"
#include "tets.hpp"

using Fast = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const std::size_t*>;

// A tet of a prism: its points and the ends of its pillar half.
struct Solid {
  std::array<Row, 4> corners;
  Row lo, hi;
};

template <class Kernel>
typename Kernel::Point_3 point(const Row& row) {
  return {row[0], row[1], row[2]};
}

template <class Kernel>
typename Kernel::Triangle_3 triangle(const Mesh& mesh, std::size_t f) {
  const Face& face = mesh.faces[f];
  return {point<Kernel>(mesh.points[face[0]]), point<Kernel>(mesh.points[face[1]]), point<Kernel>(mesh.points[face[2]])};
}

template <class Kernel>
typename Kernel::Tetrahedron_3 tetrahedron(const Solid& tet) {
  const auto& x = tet.corners;
  return {point<Kernel>(x[0]), point<Kernel>(x[1]), point<Kernel>(x[2]), point<Kernel>(x[3])};
}

// The different tets of all prisms; those on a pinched pillar are left out.
std::vector<Solid> solids(const Shell& shell) {
  std::vector<Solid> out;
  const auto local = prism_tets();
  for (const Face& face : shell.faces) {
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
  }
  return out;
}

// Do the triangle and the tet share nothing but one pinched vertex of the tet?
bool only_pinched(const Mesh& mesh, std::size_t f, const Solid& tet, const std::set<Row>& pinched) {
  if (std::none_of(tet.corners.begin(), tet.corners.end(), [&](const Row& x) { return pinched.count(x) > 0; }))
    return false;
  const auto common = CGAL::intersection(triangle<Exact>(mesh, f), tetrahedron<Exact>(tet));
  const auto* at = common ? boost::get<Exact::Point_3>(&*common) : nullptr;
  if (!at) return false;
  return std::any_of(tet.corners.begin(), tet.corners.end(),
                     [&](const Row& x) { return pinched.count(x) > 0 && point<Exact>(x) == *at; });
}

int main(int argc, char** argv) {
  if (argc != 5) refuse("usage: contacts BOTTOM.off MIDDLE.off TOP.off MESH.off");
  const Shell shell = read_shell(argv + 1);
  const Mesh mesh = read_off(argv[4]);
  std::set<Row> pinched;
  for (std::size_t v = 0; v < shell.layers[1].size(); ++v)
    if (shell.pinched(v)) pinched.insert(shell.layers[1][v]);
  const std::vector<Solid> tets = solids(shell);
  std::vector<std::size_t> triangle_ids(mesh.faces.size()), tet_ids(tets.size());
  std::iota(triangle_ids.begin(), triangle_ids.end(), 0);
  std::iota(tet_ids.begin(), tet_ids.end(), 0);
  std::vector<Box> triangles, boxes;
  for (const std::size_t& f : triangle_ids) triangles.emplace_back(triangle<Fast>(mesh, f).bbox(), &f);
  for (const std::size_t& t : tet_ids) boxes.emplace_back(tetrahedron<Fast>(tets[t]).bbox(), &t);
  std::size_t contacts = 0, touching = 0;
  const DotOf<Fast>::type dot;
  CGAL::box_intersection_d(triangles.begin(), triangles.end(), boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const std::size_t f = *a.handle();
    const Solid& tet = tets[*b.handle()];
    const auto face = triangle<Fast>(mesh, f);
    if (!CGAL::do_intersect(face, tetrahedron<Fast>(tet))) return;
    ++touching;
    if (dot(face[0], face[1], face[2], point<Fast>(tet.lo), point<Fast>(tet.hi)) == CGAL::POSITIVE) return;
    if (!only_pinched(mesh, f, tet, pinched)) ++contacts;
  });
  std::cout << "touching=" << touching << " contacts=" << contacts << '\n';
}
