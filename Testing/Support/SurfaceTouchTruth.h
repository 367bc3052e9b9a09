#pragma once

#include "Contact.h"
#include "TouchableSurfaceModel.h"
#include "WorstCase.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace palpate::test
{
/// Judges each tick of a spherical tool that starts outside of a surface model, by searches of
/// the whole surface and by following the wall that the tool met in sixteenths of a tick.
class SurfaceTouchTruth
{
public:
  static constexpr double Stiffness = 0.5; // N/mm

  struct Counts
  {
    long Ticks = 0;
    long Touching = 0;
    long Unique = 0;   ///< touching, and one wall holds the tool, at a unique place
    long Ended = 0;    ///< touching, after the minimum of the distance to the met wall has ended
    long Other = 0;    ///< of Unique: another part of the surface is nearer, as behind a thin wall
    long Inexact = 0;  ///< of Unique: the force is off by more than 1e-9 N
    long Wrong = 0;    ///< of Inexact: the proxy is off by more than 0.05 mm
    long Late = 0;     ///< no contact, though the tool overlaps the surface
    long Early = 0;    ///< contact, though the tool is free; not of Ended
    long Overlaps = 0; ///< touching, and the surface overlaps the tool at its proxy
    WorstCase Error;   ///< of the force, N, where it is inexact
    WorstCase LateDepth, EarlyGap, Overlap; ///< mm
  };

  SurfaceTouchTruth(std::shared_ptr<const TouchableSurfaceModel> surface, double radius)
      : Surface(std::move(surface)), Radius(radius)
  {
  }

  /// Starts a path. Returns false if the tool is not free there.
  bool Begin(const Vector3& probe)
  {
    this->Foot = this->NearestTo(probe);
    this->Probe = probe;
    this->IsHeld = false;
    this->IsLost = false;
    return this->Foot.SignedDistance > this->Radius + this->Surface->Margin();
  }

  void Judge(const Vector3& probe, const Contact& contact, Counts& counts)
  {
    const ClosestPoint nearest = this->NearestTo(probe);
    this->Advance(probe, nearest);
    this->IsLost = this->IsLost && (this->IsHeld || contact.IsTouching);
    ++counts.Ticks;
    counts.Touching += contact.IsTouching ? 1 : 0;
    if (contact.IsTouching != this->IsHeld)
    {
      this->CountSide(nearest, counts);
    }
    else if (contact.IsTouching)
    {
      this->CountForce(contact, nearest, counts);
    }
    if (contact.IsTouching)
    {
      const double depth =
          this->Radius - this->NearestTo(contact.ProxyWorld).SignedDistance - LeastOverlap;
      counts.Overlaps += depth > 0.0 ? 1 : 0;
      counts.Overlap.Add(std::max(0.0, depth));
    }
  }

private:
  using ClosestPoint = TouchableSurfaceModel::ClosestPoint;
  static constexpr int Parts = 16;
  static constexpr double LeastOverlap = 1e-5; // mm, about the gap that counts as contact
  static constexpr double LeastError = 1e-9;   // N
  static constexpr double WrongFrom = 0.05;    // mm

  ClosestPoint NearestTo(const Vector3& place) const
  {
    constexpr int Evaluations = 5000;
    const ClosestPoint nearest = this->Surface->Search().Nearest(place, Evaluations);
    return this->Surface->CrossesItself() ? this->Surface->SeenFrom(place, nearest) : nearest;
  }

  // Follows the wall that the tool met.
  void Advance(const Vector3& probe, const ClosestPoint& nearest)
  {
    const Vector3 start = std::exchange(this->Probe, probe);
    const bool isBeyondEdge = nearest.Normal.dot(this->Foot.Normal) < 0.0; // of a thin wall
    if (!this->IsHeld && nearest.SignedDistance >= this->Radius && !isBeyondEdge)
    {
      this->Foot = nearest;
      return;
    }
    for (int part = 1; part <= Parts; ++part)
    {
      const Vector3 place = start + (1.0 * part / Parts) * (probe - start);
      if (this->IsHeld)
      {
        this->Continue(place, (probe - start).norm() / Parts);
      }
      else
      {
        this->Foot = this->NearestTo(place);
      }
      this->IsHeld = this->Foot.SignedDistance < this->Radius;
    }
  }

  // A minimum that moves much faster than the probe is about to end, or is another one.
  void Continue(const Vector3& place, double step)
  {
    constexpr double Faster = 8.0;
    const ClosestPoint next = this->Surface->Search().Track(place, this->Foot);
    const double moved = (next.PointWorld - this->Foot.PointWorld).norm();
    this->IsLost = this->IsLost || !next.Converged() || moved > Faster * step + LeastOverlap;
    this->Foot = next;
  }

  void CountSide(const ClosestPoint& nearest, Counts& counts) const
  {
    const double depth = this->Radius - nearest.SignedDistance;
    if (this->IsHeld && depth > LeastOverlap)
    {
      ++counts.Late;
      counts.LateDepth.Add(depth);
    }
    // Behind a thin wall, where its minimum has ended, either is right.
    counts.Ended += !this->IsHeld && this->IsLost ? 1 : 0;
    if (!this->IsHeld && !this->IsLost && -depth > LeastOverlap)
    {
      ++counts.Early;
      counts.EarlyGap.Add(-depth);
    }
  }

  void CountForce(const Contact& contact, const ClosestPoint& nearest, Counts& counts) const
  {
    const Vector3 place = this->Foot.PointWorld + this->Radius * this->Foot.Normal;
    const double room = this->NearestTo(place).SignedDistance - this->Radius;
    counts.Ended += this->IsLost ? 1 : 0;
    if (this->IsLost || room < -LeastOverlap || this->IsNearOthers(this->Foot))
    {
      return;
    }
    const bool isOther = (nearest.PointWorld - this->Foot.PointWorld).norm() > WrongFrom;
    const double error = std::min((contact.ProxyWorld - place).norm(),
                                  isOther ? this->ErrorAt(contact, nearest) : 1e300);
    ++counts.Unique;
    counts.Other += isOther ? 1 : 0;
    counts.Error.Add(Stiffness * error);
    counts.Inexact += Stiffness * error <= LeastError ? 0 : 1;
    counts.Wrong += error <= WrongFrom ? 0 : 1;
  }

  double ErrorAt(const Contact& contact, const ClosestPoint& foot) const
  {
    return (contact.ProxyWorld - foot.PointWorld - this->Radius * foot.Normal).norm();
  }

  // Whether the margin of a surface that crosses itself moves the tool there.
  bool IsNearOthers(const ClosestPoint& foot) const
  {
    const double margin = this->Surface->Margin();
    const Vector3 place = foot.PointWorld + (this->Radius + margin) * foot.Normal;
    return margin > 0.0 &&
           this->NearestTo(place).SignedDistance < this->Radius + margin - LeastOverlap;
  }

  std::shared_ptr<const TouchableSurfaceModel> Surface;
  double Radius;
  ClosestPoint Foot{}; // of the wall that the tool met
  Vector3 Probe = Vector3::Zero();
  bool IsHeld = false;
  bool IsLost = false; // whether it cannot be told where the tool is, until it is free
};
} // namespace palpate::test
