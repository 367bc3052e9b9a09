#include "MessageOf.h"
#include "SegmentationFile.h"
#include "StoredImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::gipl_format_test
{
namespace
{
using namespace palpate::test;

std::string Plain(const GiplSpec& spec = {})
{
  return GiplBytes(spec, BytesOf(Counting<unsigned char>(120)));
}

template <typename T>
void ExpectKeepsType(std::uint16_t code, int vtkType)
{
  GiplSpec spec;
  spec.Type = code;
  const std::vector<T> values = Counting<T>(120);
  const Volume volume = ReadBytes("a.gipl", GiplBytes(spec, BigEndian(values)));
  ASSERT_EQ(volume.Image->GetScalarType(), vtkType);
  const T* found = static_cast<const T*>(volume.Image->GetScalarPointer());
  EXPECT_TRUE(std::equal(values.begin(), values.end(), found));
}

TEST(GiplFormat, KeepsVoxelsOfEveryType)
{
  ExpectKeepsType<unsigned char>(1, VTK_UNSIGNED_CHAR);
  ExpectKeepsType<signed char>(7, VTK_SIGNED_CHAR);
  ExpectKeepsType<unsigned char>(8, VTK_UNSIGNED_CHAR);
  ExpectKeepsType<short>(15, VTK_SHORT);
  ExpectKeepsType<unsigned short>(16, VTK_UNSIGNED_SHORT);
  ExpectKeepsType<unsigned int>(31, VTK_UNSIGNED_INT);
  ExpectKeepsType<int>(32, VTK_INT);
  ExpectKeepsType<float>(64, VTK_FLOAT);
  ExpectKeepsType<double>(65, VTK_DOUBLE);
}

// Positions as ITK 5.2's GiplImageIO reports them: axes L, P, S from the stated origin.
TEST(GiplFormat, PlacesVoxelsAsItkAndNotesIt)
{
  GiplSpec spec;
  spec.Spacing = {1.5F, 2, 3};
  for (const auto& [name, bytes] :
       {std::pair<std::string, std::string>{"a.gipl", Plain(spec)},
        std::pair<std::string, std::string>{"a.gipl.gz", Gzipped(Plain(spec))}})
  {
    const Volume volume = ReadBytes(name, bytes);
    Vector3 world;
    volume.Image->TransformIndexToPhysicalPoint(3, 4, 5, world.data());
    EXPECT_EQ(world, Vector3(14.5, 28, 45));
    EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(3, 4, 5, 0), 119.0);
    ASSERT_EQ(volume.Notes.size(), 1u);
    EXPECT_TRUE(Contains(volume.Notes[0], "check left and right"));
  }
}

TEST(GiplFormat, ReadsEitherMark)
{
  GiplSpec spec;
  spec.Mark = 0xefffe9b0;
  EXPECT_EQ(ReadBytes("a.gipl", Plain(spec)).Image->GetDimensions()[2], 6);
  spec.Mark = 0xefffe9b1;
  EXPECT_TRUE(Contains(RefusalOf("a.gipl", Plain(spec)), "is not a GIPL file"));
}

TEST(GiplFormat, VolumeIsChosenByNumber)
{
  GiplSpec spec;
  spec.Sizes[3] = 2;
  const std::string bytes = GiplBytes(spec, std::string(120, '\1') + std::string(120, '\2'));
  EXPECT_TRUE(Contains(RefusalOf("a.gipl", bytes), "holds 2 volumes"));
  EXPECT_EQ(ReadBytes("a.gipl", bytes, {"2"}).Image->GetScalarComponentAsDouble(0, 0, 0, 0), 2.0);
}

TEST(GiplFormat, UnusedFourthAxisIsOneVolume)
{
  GiplSpec spec;
  spec.Sizes[3] = 0;
  EXPECT_EQ(ReadBytes("a.gipl", Plain(spec)).Image->GetDimensions()[2], 6);
}

TEST(GiplFormat, RejectsFilesTruncatedAnywhere)
{
  ExpectTruncationsAreRefused("a.gipl", Plain());
  ExpectTruncationsAreRefused("a.gipl.gz", Gzipped(Plain()));
}

TEST(GiplFormat, RejectsAbsurdSizesTypesAndGeometry)
{
  const auto refusal = [](auto change)
  {
    GiplSpec spec;
    change(spec);
    return RefusalOf("a.gipl", Plain(spec));
  };
  constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(Contains(refusal(
                           [](GiplSpec& s) {
                             s.Sizes = {65535, 65535, 65535, 1};
                           }),
                       "is truncated"));
  EXPECT_TRUE(Contains(refusal(
                           [](GiplSpec& s) {
                             s.Sizes = {65535, 65535, 65535, 65535};
                           }),
                       "truncated"));
  EXPECT_TRUE(Contains(refusal([](GiplSpec& s) { s.Sizes = {4, 30, 0, 0}; }), "two-dimensional"));
  EXPECT_TRUE(Contains(refusal([](GiplSpec& s) { s.Type = 192; }), "not supported (code 192)"));
  EXPECT_TRUE(Contains(refusal([](GiplSpec& s) { s.Spacing[2] = -1; }), "voxel spacing of -1"));
  EXPECT_TRUE(Contains(refusal([](GiplSpec& s) { s.Spacing[2] = NaN; }), "voxel spacing of"));
  EXPECT_TRUE(Contains(refusal([](GiplSpec& s) { s.Origin[0] = double{NaN}; }), "not finite"));
}
} // namespace
} // namespace palpate::gipl_format_test
