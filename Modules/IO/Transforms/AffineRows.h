#pragma once

#include "MapRows.h"

#include <Eigen/Geometry>

namespace palpate
{
inline MapRows ToMapRows(const Eigen::Affine3d& map)
{
  MapRows rows{};
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    Eigen::Map<Eigen::RowVector4d>(rows[row].data()) =
        map.matrix().row(static_cast<Eigen::Index>(row));
  }
  return rows;
}

inline Eigen::Affine3d ToAffine(const MapRows& rows)
{
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    map.matrix().row(static_cast<Eigen::Index>(row)) =
        Eigen::Map<const Eigen::RowVector4d>(rows[row].data());
  }
  return map;
}
} // namespace palpate
