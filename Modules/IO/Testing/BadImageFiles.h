#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::test
{
/// A file that every reader must refuse, and a part of the message.
struct BadFile
{
  std::string Name;
  std::string Bytes;
  std::string Fact;
};

std::vector<BadFile> BadNiftiFiles();
std::vector<BadFile> BadNrrdFiles();
std::vector<BadFile> BadOtherFiles(); ///< MetaImage, DICOM, and other formats
/// Compressed data that are truncated, damaged, or do not match their header.
std::vector<BadFile> BadCompressedFiles();

/// A raw NRRD of floats, one of which is `odd`.
std::string NrrdOfFloats(float odd);
/// Values that compress by half, so that a truncated or overwritten part affects many of them.
std::string Noise(std::size_t count);
/// 40 x 50 x 60 bytes of noise.
std::string LargeNifti();
/// The same size; its voxels compressed, or in a separate file.
std::string LargeMetaImage(const std::string& packed, const std::string& dataFile = "LOCAL");
std::string LargeNrrd(const std::string& packed);
} // namespace palpate::test
