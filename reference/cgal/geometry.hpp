// Rows as points, triangles and boxes of CGAL's kernels.
#pragma once
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

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

// 0, 1, 2, ...: what the handles of boxes point to. CGAL takes boxes with handles of one address for one box, and reports
// no pair of it: two sets of boxes need two lists.
inline std::vector<std::size_t> ids_of(std::size_t count) {
  std::vector<std::size_t> out(count);
  std::iota(out.begin(), out.end(), 0);
  return out;
}

inline std::vector<Box> triangle_boxes(const std::vector<Row>& rows, const std::vector<Face>& faces,
                                       const std::vector<std::size_t>& ids) {
  std::vector<Box> out;
  out.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) out.emplace_back(triangle<Fast>(rows, faces[i]).bbox(), &ids[i]);
  return out;
}
