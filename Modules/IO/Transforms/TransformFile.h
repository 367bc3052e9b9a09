#pragma once

#include "PalpateIOModule.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Files of the images whose frames FLIRT's matrices are in; empty where there are none.
struct TransformImages
{
  std::filesystem::path Moving;
  std::filesystem::path Fixed;
};

/// Endings of files that ReadTransform reads and WriteTransform writes.
PALPATEIO_EXPORT const std::vector<std::string>& TransformEndings();

/// An affine map of the patient's space (LPS, mm) that brings a moving body onto a fixed one, from
/// a file of another program, by its ending:
/// - .tfm, .txt: ITK's text, which maps places of the fixed image to the moving one (LPS), so it is
///   inverted; rigid, similarity and affine transforms of three dimensions. 3D Slicer reads it as a
///   linear transform that moves the moving volume onto the fixed one.
/// - .h5: the same in HDF5, which a process of its own reads and writes.
/// - .lta: FreeSurfer, type 1 (RAS to RAS), from the moving to the fixed volume.
/// - .xfm: MINC, linear, from the moving (native) to the fixed space (RAS).
/// - .mat: FSL's FLIRT, from the moving (in) to the fixed image (ref), in their own coordinates
///   (FslSpaceOf), so it needs the headers of both images.
/// Throws InputError for images that are missing, damaged files, other kinds of transforms, several
/// of them, numbers that are not finite, and maps that cannot be inverted.
PALPATEIO_EXPORT Eigen::Affine3d ReadTransform(const std::filesystem::path& file,
                                               const TransformImages& images = {});

/// Writes such a map in full precision; an .lta without the volumes' geometry (valid = 0). Throws
/// InputError for other endings, and a file that cannot be written.
PALPATEIO_EXPORT void WriteTransform(const std::filesystem::path& file, const Eigen::Affine3d& map,
                                     const TransformImages& images = {});
} // namespace palpate
