#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// Compressed DICOM files for tests: made from uncompressed ones with DCMTK's and OpenJPEG's
/// encoders, and split into fragments.
namespace palpate::test
{
enum class Codec
{
  RunLength,
  JpegBaseline, ///< lossy
  JpegExtended, ///< lossy, 12 bits
  JpegLossless,
  JpegLs,
  JpegLsNearLossless, ///< off by 2 at most
  Jpeg2000,
  Jpeg2000Lossy
};
constexpr Codec LosslessCodecs[] = {Codec::RunLength, Codec::JpegLossless, Codec::JpegLs,
                                    Codec::Jpeg2000};

const char* CodecName(Codec codec);

/// Encodes the pixels of an uncompressed file in place: one fragment per frame, an empty offset
/// table.
void Compress(const std::filesystem::path& file, Codec codec);

/// The compressed streams of a file, one per fragment.
std::vector<std::string> Fragments(const std::filesystem::path& file);

/// Replaces the streams. `offsets` are those of the offset table.
void ReplaceFragments(const std::filesystem::path& file, const std::vector<std::string>& fragments,
                      const std::vector<std::uint32_t>& offsets = {});

/// Changes only the transfer syntax in the file's meta header.
void StateTransferSyntax(const std::filesystem::path& file, const std::string& uid);

/// A JPEG 2000 codestream of grey values. `ratio` above 1 makes it lossy.
std::string Jpeg2000Stream(const std::vector<int>& values, int columns, int rows, int precision,
                           bool isSigned, int ratio = 1);
} // namespace palpate::test
