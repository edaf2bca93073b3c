// Claim C6 `disjoint`: the mesh against itself, and against the shell's bottom and top.
#pragma once
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>

#include "geometry.hpp"

// Pairs of mesh triangles that share more than their common vertices force.
inline std::size_t self_hits(const Mesh& mesh) {
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
inline bool only_pinched(const Mesh& mesh, const Face& f, const Shell& shell, const std::vector<Row>& layer, const Face& g) {
  const auto common = CGAL::intersection(triangle<Exact>(mesh.points, f), triangle<Exact>(layer, g));
  if (!common) return true;
  const auto* at = boost::get<Exact::Point_3>(&*common);
  if (!at) return false;
  for (std::size_t v : g)
    if (shell.pinched(v) && point<Exact>(layer[v]) == *at) return true;
  return false;
}

// Pairs of a mesh triangle and one of a layer that share a point other than a pinched vertex.
inline std::size_t layer_hits(const Mesh& mesh, const Shell& shell, int layer) {
  const auto& points = shell.layers[layer];
  const auto mesh_ids = ids_of(mesh.faces.size()), shell_ids = ids_of(shell.faces.size());
  auto first = triangle_boxes(mesh.points, mesh.faces, mesh_ids), second = triangle_boxes(points, shell.faces, shell_ids);
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
