#pragma once

#include "IndexedMesh.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// A section of a tube, perpendicular to its axis.
struct CalibreSection
{
  double Along = 0.0;               ///< mm of the axis, from its first end
  Vector3 Center = Vector3::Zero(); ///< of the section's area; here the axis is
  Vector3 Axis = Vector3::Zero();   ///< unit vector
  double Area = 0.0;                ///< mm^2 within the outer curve of the section
  double Least = 0.0;               ///< mm: its least and its largest width
  double Largest = 0.0;

  /// Of the circle with this area, mm.
  double Diameter() const noexcept;
};

/// The axis of a tube, and how wide it is along it.
struct Calibre
{
  /// Tubes shorter than as many of their mean diameters have no axis of their own.
  static constexpr double LeastLength = 5.0;

  bool IsLong = false; ///< also of a body that has no calibre for another reason
  double Length = 0.0; ///< mm of the axis, from one end of the body to the other
  /// A quarter of the mean diameter apart, up to one radius from the ends, where what a section
  /// cuts is the end.
  std::vector<CalibreSection> Sections;

  /// The section at which the diameter is the quantile `part`: 0 least, 0.5 median, 1 largest.
  const CalibreSection& At(double part) const;
};

/// The calibre of a closed body that is one long tube (mm, oriented outwards), of its largest sheet
/// of triangles. The first axis runs through the curves of equal distance from an end, as in
/// Verroust and Lazarus, "Extracting skeletal curves from 3D scattered data", Visual Computer 16
/// (2000), and goes on straight from section to section towards the ends. Planes perpendicular to
/// it give the sections, whose centroids are the axis. It ends where it leaves the body, straight
/// on from the last section.
///
/// Fails for a body that is not long, one with branches or rings (two curves of equal distance from
/// an end over more than 0.6 of the mean diameter, the smaller at least 0.3 of the larger), and if
/// the sections along the axis hold less than 4/5 or more than 6/5 of the volume, so that they are
/// not those of a tube. Messages are predicates; `measured` then has no sections.
Status MeasureCalibre(const IndexedMesh& mesh, Calibre& measured);
} // namespace palpate
