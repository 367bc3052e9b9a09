#include "AddressSpaceLimit.h"
#include "BadImageFiles.h"
#include "MessageOf.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include <gtest/gtest.h>

namespace palpate::hostile_meta_images_test
{
namespace
{
using namespace palpate::test;

// Headers that overflow the MetaIO library, that it reads differently, or that leave voxels
// uninitialised.
constexpr rlim_t SomeMemory = rlim_t{1} << 30; // limit for reading a file of some bytes
constexpr const char* DataLine = "ElementDataFile = LOCAL";

std::string Voxels()
{
  return std::string(120, '\1');
}

// A good file with lines inserted before the one that starts with `before`.
std::string With(const std::string& lines, const std::string& before = "ElementDataFile",
                 const std::string& voxels = Voxels())
{
  std::string bytes = MetaImageBytes("MET_UCHAR", voxels);
  return bytes.insert(bytes.find(before), lines + "\n");
}

std::string Replaced(std::string bytes, const std::string& from, const std::string& to)
{
  return bytes.replace(bytes.find(from), from.size(), to);
}

std::string TextImage(const std::string& type, const std::string& numbers)
{
  return Replaced(MetaImageBytes(type, numbers), "BinaryData = True", "BinaryData = False");
}

std::string Repeated(const std::string& text, int times)
{
  std::string all;
  for (int i = 0; i < times; ++i)
  {
    all += text;
  }
  return all;
}

class HostileMetaImages : public testing::Test
{
protected:
  std::string Refusal(const std::string& bytes, const std::string& name = "a.mha") const
  {
    WriteAll(this->Folder / name, bytes);
    const AddressSpaceLimit limit(SomeMemory);
    return MessageOf([&] { ReadVolume(this->Folder / name); });
  }
  // For a header whose voxels are in another file with this content.
  std::string RefusalNextTo(const std::string& data, const std::string& line) const
  {
    WriteAll(this->Folder / "a.raw", data);
    return this->Refusal(
        Replaced(With(line, "ElementDataFile", ""), DataLine, "ElementDataFile = a.raw"), "a.mhd");
  }

  TemporaryFolder Folder;
};

TEST_F(HostileMetaImages, BoundsWordsAndDigitsInPlaceOfWords)
{
  for (const char* key : {"ObjectType", "Comment", "Name", "ObjectSubType", "TransformType",
                          "AcquisitionDate", "DistanceUnits", "AnatomicalOrientation", "NoSuchKey"})
  {
    for (const char letter : {'1', 'I'})
    {
      const std::string message =
          this->Refusal(With(std::string(key) + " = " + std::string(255, letter), "DimSize"));
      EXPECT_TRUE(Contains(message, std::string("has 255 characters of ") + key)) << message;
    }
  }
}

TEST_F(HostileMetaImages, ReadsWordsOfMaximumLength)
{
  EXPECT_EQ(this->Refusal(With("Comment = " + std::string(254, '1'), "DimSize")), "no error");
}

TEST_F(HostileMetaImages, ReadsLongListsOfNumbers)
{
  const std::string matrix = "TransformMatrix = 1 0 0 0 1 0 0 0 1";
  std::string digits = matrix;
  for (std::size_t at = digits.size(); at-- > matrix.find('1');)
  {
    if (digits[at] != ' ')
    {
      digits.insert(at + 1, "." + std::string(40, '0'));
    }
  }
  EXPECT_EQ(this->Refusal(Replaced(With("ID = 1"), matrix, digits)), "no error");
}

// The library reads at most 499 characters of a name, then fails silently.
TEST_F(HostileMetaImages, BoundsDataFileNames)
{
  const std::string line = DataLine + std::string(500, ' ');
  EXPECT_TRUE(Contains(this->Refusal(Replaced(With("ID = 1"), DataLine, line)),
                       "characters of ElementDataFile"));
}

// For the library, a colon is a separator like the equals sign.
TEST_F(HostileMetaImages, RejectsLinesWithColonFirst)
{
  for (const char* line :
       {"DimSize : 1500 1500 1000 =", "ElementDataFile : LIST =", "ElementDataFile : %s%n 1 6 1 =",
        "ElementNumberOfChannels : 100000 =", "Comment : a = b", "NDims : 12 ="})
  {
    EXPECT_TRUE(Contains(this->Refusal(With(line)), "a colon before the equals sign")) << line;
  }
}

TEST_F(HostileMetaImages, RejectsLinesWithTwoSeparators)
{
  for (const char* line : {"CompressedData = :True", "HeaderSize == 5", "HeaderSize = : 5"})
  {
    EXPECT_TRUE(Contains(this->Refusal(Replaced(With(line), "CompressedData = False\n", "")),
                         "two separators in a row"))
        << line;
  }
}

// The library ends a name at a carriage return and skips other blanks before one.
TEST_F(HostileMetaImages, RejectsControlCharacters)
{
  for (const std::string& line :
       {std::string("DimSize\rFoo = 1500 1500 1000"), std::string("\vDimSize = 1500 1500 1000"),
        std::string("\fDimSize = 1500 1500 1000"), std::string("DimSize\0x = 1500 1500 1000", 26),
        std::string("Comment = a\rb"), std::string("Comment = a\0b", 13)})
  {
    EXPECT_TRUE(Contains(this->Refusal(With(line)), "is not a MetaImage file")) << line;
  }
}

TEST_F(HostileMetaImages, ReadsLinesWithCarriageReturns)
{
  std::string bytes = With("ID = 1");
  for (std::size_t at = 0; (at = bytes.find('\n', at)) != std::string::npos; at += 2)
  {
    bytes.insert(at, "\r");
  }
  EXPECT_EQ(this->Refusal(bytes), "no error");
}

TEST_F(HostileMetaImages, RejectsDuplicateFields)
{
  for (const char* line : {"DimSize = 4 5 6", "NDims = 3", "Foo = 1\nFoo = 1"})
  {
    EXPECT_TRUE(Contains(this->Refusal(With(line)), "more than once in its header")) << line;
  }
}

// The library continues with the next line's numbers.
TEST_F(HostileMetaImages, RejectsFieldsWithTooFewNumbers)
{
  for (const char* lines : {"ID =\n5 = x", "Color = 1 1\n1 1 = x", "HeaderSize =\n100 = x",
                            "CenterOfRotation = 0 0\n0 = x", "Rotation = 1 0 0 0 1 0 0 0\n1 = x"})
  {
    EXPECT_TRUE(Contains(this->Refusal(With(lines)), "damaged header")) << lines;
  }
}

// The library allocates a 33 kB record for each.
TEST_F(HostileMetaImages, BoundsNumberOfLines)
{
  std::string lines;
  for (int line = 0; line < 200000; ++line)
  {
    lines += "k" + std::to_string(line) + " = v\n";
  }
  EXPECT_TRUE(Contains(this->Refusal(With(lines + "ID = 1")), "more than 10000 lines"));
}

TEST_F(HostileMetaImages, BytesBeforeVoxelsAreNotCounted)
{
  for (const char* size : {"1", "100", "100000"})
  {
    EXPECT_TRUE(Contains(this->RefusalNextTo(Voxels(), std::string("HeaderSize = ") + size),
                         "is truncated: its header declares 120 bytes of voxels"))
        << size;
  }
}

TEST_F(HostileMetaImages, ReadsVoxelsAfterOwnHeader)
{
  EXPECT_EQ(this->RefusalNextTo(std::string(100, '\0') + Voxels(), "HeaderSize = 100"), "no error");
  EXPECT_EQ(this->RefusalNextTo(std::string(100, '\0') + Voxels(), "HeaderSize = -1"), "no error");
}

TEST_F(HostileMetaImages, RejectsInvalidHeaderSizes)
{
  for (const char* size : {"1e300", "-2", "0.5", "5000000000"})
  {
    EXPECT_TRUE(Contains(this->RefusalNextTo(Voxels(), std::string("HeaderSize = ") + size),
                         "damaged header (HeaderSize)"))
        << size;
  }
  EXPECT_TRUE(Contains(this->Refusal(With("HeaderSize = 10")), "damaged header (HeaderSize)"));
}

TEST_F(HostileMetaImages, RejectsHeaderSizeWithCompression)
{
  const std::string packed = Deflated(Voxels());
  WriteAll(this->Folder / "a.raw", "12345" + packed);
  std::string header = With("HeaderSize = 5\nCompressedDataSize = " + std::to_string(packed.size()),
                            "ElementDataFile", "");
  header = Replaced(header, DataLine, "ElementDataFile = a.raw");
  EXPECT_TRUE(Contains(
      this->Refusal(Replaced(header, "CompressedData = False", "CompressedData = True"), "a.mhd"),
      "damaged header (HeaderSize)"));
}

TEST_F(HostileMetaImages, RejectsWrongCompressedSizes)
{
  const std::string packed = Deflated(Voxels());
  for (const char* size : {"-5", "1e16", "100000000000", "0.5"})
  {
    std::string bytes =
        With(std::string("CompressedDataSize = ") + size, "ElementDataFile", packed);
    bytes = Replaced(bytes, "CompressedData = False", "CompressedData = True");
    EXPECT_TRUE(Contains(this->Refusal(bytes), "CompressedDataSize")) << size;
  }
}

TEST_F(HostileMetaImages, HeaderAtEndOfFileHasNoVoxels)
{
  std::string bytes = With("ID = 1", "ElementDataFile", "");
  bytes.pop_back();
  EXPECT_TRUE(Contains(this->Refusal(bytes), "is truncated"));
}

TEST_F(HostileMetaImages, ReadsTextVoxels)
{
  EXPECT_EQ(this->Refusal(TextImage("MET_UCHAR", Repeated("1 ", 120))), "no error");
}

TEST_F(HostileMetaImages, RejectsMissingTextVoxels)
{
  for (const std::string& text :
       {Repeated("1 ", 60), Repeated("1 ", 119) + std::string(100, ' '), Repeated("1", 500),
        Repeated("1 ", 60) + "x " + Repeated("1 ", 60)})
  {
    EXPECT_TRUE(Contains(this->Refusal(TextImage("MET_UCHAR", text)),
                         "is truncated: its header declares 120 voxels"));
  }
}

TEST_F(HostileMetaImages, RejectsTextVoxelsBeyondType)
{
  for (const char* number : {"256 ", "-1 ", "1e300 "})
  {
    EXPECT_TRUE(
        Contains(this->Refusal(TextImage("MET_UCHAR", Repeated("1 ", 119) + number)), "MET_UCHAR"))
        << number;
  }
}

// For the library, a name that starts with a tilde is in the working folder.
TEST_F(HostileMetaImages, DataFilePathMatchesLibrary)
{
  WriteAll(this->Folder / "~a.raw", Voxels());
  EXPECT_TRUE(Contains(this->Refusal(Replaced(With("ID = 1", "ElementDataFile", ""), DataLine,
                                              "ElementDataFile = ~a.raw"),
                                     "a.mhd"),
                       "lacks its data file ~a.raw"));
}

// The library strips all unprintable characters from the end of a word.
TEST_F(HostileMetaImages, WordsEndAsInLibrary)
{
  WriteAll(this->Folder / "LOCAL\xff", Voxels());
  EXPECT_TRUE(Contains(this->Refusal(Replaced(With("ID = 1", "ElementDataFile", ""), DataLine,
                                              std::string(DataLine) + "\xff")),
                       "is truncated"));
}
} // namespace
} // namespace palpate::hostile_meta_images_test
