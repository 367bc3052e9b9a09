#include "ExpandedParts.h"

#include "TangentQuadratic.h"

namespace palpate
{
namespace
{
void Dot(const FourLanes (&a)[3], const FourLanes (&b)[3], FourLanes& product) noexcept
{
  product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
} // namespace

void ExpandedParts::Put(std::size_t part, const Vector3& vector, Coordinates& lanes) noexcept
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    lanes[i][part] = vector[static_cast<Eigen::Index>(i)];
  }
}

void ExpandedParts::Set(std::size_t part, const CenteredSurface::SecondOrderSample& sample,
                        double reach,
                        const ClosestPointDescentOf<CenteredSurface>::CapBounds& bounds) noexcept
{
  const auto& [first, second] = sample.First;
  Put(part, sample.Point, this->Point);
  Put(part, first, this->First[0]);
  Put(part, second, this->First[1]);
  for (std::size_t i = 0; i < 3; ++i)
  {
    Put(part, sample.Second[i], this->Second[i]);
  }
  this->Metric[0][part] = first.squaredNorm();
  this->Metric[1][part] = first.dot(second);
  this->Metric[2][part] = second.squaredNorm();
  this->Reach[part] = reach;
  this->Product[part] = bounds.Product;
  this->Third[part] = bounds.Third;
  this->Longer[part] = reach * (bounds.First + 0.5 * reach * bounds.Second);
  this->Extent[part] = bounds.Extent(reach);
}

void ExpandedParts::Bound(const Vector3& place, FourLanes& lower) const noexcept
{
  const Coordinates offset{place[0] - this->Point[0], place[1] - this->Point[1],
                           place[2] - this->Point[2]};
  FourLanes square, length, aa, ab, bb, a, b, change;
  Dot(offset, offset, square);
  Dot(offset, this->Second[0], aa);
  Dot(offset, this->Second[1], ab);
  Dot(offset, this->Second[2], bb);
  Dot(offset, this->First[0], a);
  Dot(offset, this->First[1], b);
  const TangentQuadratic<FourLanes> quadratic{this->Metric[0] - aa, this->Metric[1] - ab,
                                              this->Metric[2] - bb, -a, -b};
  quadratic.LeastChange(this->Reach, change);
  SquareRoot(square, length);
  const FourLanes fall = this->Product + (length + this->Longer) * this->Third;
  const FourLanes cube = this->Reach * this->Reach * this->Reach;
  SquareRoot(square + 2.0 * change - cube * fall * (1.0 / 3.0), lower);
}

// Compiled twice, like the tracking of closest points: everything is inlined here.
[[gnu::flatten]] void ExpandedParts::BoundPortably(const Vector3& place,
                                                   FourLanes& lower) const noexcept
{
  this->Bound(place, lower);
}

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]]
#endif
[[gnu::flatten]] void
ExpandedParts::BoundByAvx2(const Vector3& place, FourLanes& lower) const noexcept
{
  this->Bound(place, lower);
}

void ExpandedParts::LowerDistance(const Vector3& place, InstructionSet set,
                                  FourLanes& lower) const noexcept
{
  if (set == InstructionSet::Avx2)
  {
    this->BoundByAvx2(place, lower);
  }
  else
  {
    this->BoundPortably(place, lower);
  }
}
} // namespace palpate
