// Claim C6 `disjoint` with CGAL: the mesh against itself, and against the shell's bottom and top.
//
//   checks BOTTOM.off MIDDLE.off TOP.off MESH.off
//
// Prints one line of key=value: pairs of mesh triangles that share more than their common vertices force (`self`), and
// pairs of a mesh triangle and a bottom or top triangle that share a point other than a pinched vertex.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>

#include <iterator>
#include <numeric>

#include "off.hpp"

using Fast = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const std::size_t*>;

template <class Kernel>
typename Kernel::Point_3 point(const Row& row) {
  return {row[0], row[1], row[2]};
}

template <class Kernel>
typename Kernel::Triangle_3 triangle(const std::vector<Row>& points, const Face& face) {
  return {point<Kernel>(points[face[0]]), point<Kernel>(points[face[1]]), point<Kernel>(points[face[2]])};
}

std::size_t self_hits(const Mesh& mesh) {
  using Surface = CGAL::Surface_mesh<Fast::Point_3>;
  Surface surface;
  for (const Row& row : mesh.points) surface.add_vertex(point<Fast>(row));
  for (const Face& f : mesh.faces) {
    const auto vertex = [&](int i) { return Surface::Vertex_index(static_cast<Surface::size_type>(f[i])); };
    if (surface.add_face(vertex(0), vertex(1), vertex(2)) == Surface::null_face()) refuse("the mesh is no manifold");
  }
  std::vector<std::pair<Surface::Face_index, Surface::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(pairs));
  return pairs.size();
}

// Do the triangles share nothing but one pinched vertex of the second?
bool only_pinched(const Mesh& mesh, const Face& f, const Shell& shell, const std::vector<Row>& layer, const Face& g) {
  const auto common = CGAL::intersection(triangle<Exact>(mesh.points, f), triangle<Exact>(layer, g));
  if (!common) return true;
  const auto* at = boost::get<Exact::Point_3>(&*common);
  if (!at) return false;
  for (std::size_t v : g)
    if (shell.pinched(v) && point<Exact>(layer[v]) == *at) return true;
  return false;
}

std::size_t layer_hits(const Mesh& mesh, const Shell& shell, int layer) {
  const auto& points = shell.layers[layer];
  // Two lists: CGAL takes boxes with handles of one address for one box, and reports no pair of it.
  std::vector<std::size_t> mesh_ids(mesh.faces.size()), shell_ids(shell.faces.size());
  std::iota(mesh_ids.begin(), mesh_ids.end(), 0);
  std::iota(shell_ids.begin(), shell_ids.end(), 0);
  const auto boxes = [](const std::vector<Row>& rows, const std::vector<Face>& faces, const auto& ids) {
    std::vector<Box> out;
    for (std::size_t i = 0; i < faces.size(); ++i) out.emplace_back(triangle<Fast>(rows, faces[i]).bbox(), &ids[i]);
    return out;
  };
  auto first = boxes(mesh.points, mesh.faces, mesh_ids), second = boxes(points, shell.faces, shell_ids);
  std::size_t hits = 0;
  const auto meet = [&](const Box& a, const Box& b) {
    const Face &f = mesh.faces[*a.handle()], &g = shell.faces[*b.handle()];
    if (!CGAL::do_intersect(triangle<Fast>(mesh.points, f), triangle<Fast>(points, g))) return;
    const bool pinched = shell.pinched(g[0]) || shell.pinched(g[1]) || shell.pinched(g[2]);
    if (!pinched || !only_pinched(mesh, f, shell, points, g)) ++hits;
  };
  CGAL::box_intersection_d(first.begin(), first.end(), second.begin(), second.end(), meet);
  return hits;
}

int main(int argc, char** argv) {
  if (argc != 5) refuse("usage: checks BOTTOM.off MIDDLE.off TOP.off MESH.off");
  const Shell shell = read_shell(argv + 1);
  const Mesh mesh = read_off(argv[4]);
  std::cout << "self=" << self_hits(mesh) << " bottom=" << layer_hits(mesh, shell, 0)
            << " top=" << layer_hits(mesh, shell, 2) << '\n';
}
