#include "FieldGrid.h"

#include <limits>

namespace palpate
{
FieldGrid::FieldGrid(const std::array<int, 3>& size, const Vector3& originWorld,
                     const Vector3& spacing, const Matrix3& direction)
    : Nodes(size), Origin(originWorld), Steps(spacing), Axes(direction),
      ToWorld(direction * spacing.asDiagonal()), ToIndex(ToWorld.inverse())
{
}

Status FieldGrid::Check() const
{
  constexpr int MostNodes = 1 << 16;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int nodes = this->Nodes[static_cast<std::size_t>(axis)];
    if (nodes < 2 || nodes > MostNodes)
    {
      return Status::Failure("The volume has " + std::to_string(nodes) + " samples along axis " +
                             std::to_string(axis) + "; a field needs 2 to " +
                             std::to_string(MostNodes) + ".");
    }
    if (!(this->Steps[axis] > 0.0) || this->Steps[axis] > std::numeric_limits<float>::max())
    {
      return Status::Failure("The spacing along axis " + std::to_string(axis) +
                             " is not a positive length.");
    }
  }
  if (!this->Origin.allFinite())
  {
    return Status::Failure("The volume's origin is not a point.");
  }
  constexpr double Tolerance = 1e-4; // files store directions as float, some with few digits
  const Matrix3 excess = this->Axes.transpose() * this->Axes - Matrix3::Identity();
  if (!(excess.cwiseAbs().maxCoeff() <= Tolerance) || !(this->Axes.determinant() > 0.0))
  {
    return Status::Failure("The volume's direction is not a right-handed rotation.");
  }
  return Status::Success();
}

std::size_t FieldGrid::NodeCount() const noexcept
{
  return static_cast<std::size_t>(this->Nodes[0]) * static_cast<std::size_t>(this->Nodes[1]) *
         static_cast<std::size_t>(this->Nodes[2]);
}
} // namespace palpate
