#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::test
{
/// A file that every reader must refuse, and what the sentence says.
struct BadFile
{
  std::string Name;
  std::string Bytes;
  std::string Fact;
};

std::vector<BadFile> BadNiftiFiles();
std::vector<BadFile> BadNrrdFiles();
std::vector<BadFile> BadOtherFiles(); ///< MetaImage, DICOM, and none of them
/// Compressed data that end early, are damaged, or do not fit their header.
std::vector<BadFile> BadCompressedFiles();

/// A raw NRRD of floats, one of which is odd.
std::string NrrdOfFloats(float odd);
/// Values that compress by half, so that a cut or an overwritten part takes many with it.
std::string Noise(std::size_t count);
/// 40 x 50 x 60 bytes of noise.
std::string LargeNifti();
/// The same size; its voxels packed, or in a file of their own.
std::string LargeMetaImage(const std::string& packed, const std::string& dataFile = "LOCAL");
std::string LargeNrrd(const std::string& packed);
} // namespace palpate::test
