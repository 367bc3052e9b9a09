#include "Jpeg2000Decoder.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <openjpeg.h>

namespace palpate
{
namespace
{
struct Codestream
{
  const std::uint8_t* Bytes;
  std::size_t Size;
  std::size_t Place = 0;
};

// OpenJPEG's return values at the end of a stream.
constexpr auto NothingRead = static_cast<OPJ_SIZE_T>(-1);
constexpr OPJ_OFF_T NothingSkipped = -1;

OPJ_SIZE_T Read(void* buffer, OPJ_SIZE_T count, void* user)
{
  auto& stream = *static_cast<Codestream*>(user);
  const std::size_t available = std::min<std::size_t>(count, stream.Size - stream.Place);
  if (available == 0)
  {
    return NothingRead;
  }
  std::memcpy(buffer, stream.Bytes + stream.Place, available);
  stream.Place += available;
  return available;
}

OPJ_OFF_T Skip(OPJ_OFF_T count, void* user)
{
  auto& stream = *static_cast<Codestream*>(user);
  if (count < 0 || static_cast<std::size_t>(count) > stream.Size - stream.Place)
  {
    return NothingSkipped;
  }
  stream.Place += static_cast<std::size_t>(count);
  return count;
}

OPJ_BOOL Seek(OPJ_OFF_T place, void* user)
{
  auto& stream = *static_cast<Codestream*>(user);
  if (place < 0 || static_cast<std::size_t>(place) > stream.Size)
  {
    return OPJ_FALSE;
  }
  stream.Place = static_cast<std::size_t>(place);
  return OPJ_TRUE;
}

using StreamPointer = std::unique_ptr<opj_stream_t, decltype(&opj_stream_destroy)>;
using CodecPointer = std::unique_ptr<opj_codec_t, decltype(&opj_destroy_codec)>;
using ImagePointer = std::unique_ptr<opj_image_t, decltype(&opj_image_destroy)>;

StreamPointer OpenStream(Codestream& source)
{
  StreamPointer stream(opj_stream_default_create(OPJ_TRUE), &opj_stream_destroy);
  if (stream)
  {
    opj_stream_set_read_function(stream.get(), &Read);
    opj_stream_set_skip_function(stream.get(), &Skip);
    opj_stream_set_seek_function(stream.get(), &Seek);
    opj_stream_set_user_data(stream.get(), &source, nullptr);
    opj_stream_set_user_data_length(stream.get(), source.Size);
  }
  return stream;
}

// The SIZ marker segment, which must be the first (T.800, A.5.1).
struct ImageSize
{
  std::uint64_t Columns;
  std::uint64_t Rows;
  std::uint64_t Tiles;
  int Components;
};

std::uint64_t Number(const std::uint8_t* bytes, std::size_t count)
{
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    value = value << 8 | bytes[i];
  }
  return value;
}

// Where the codestream starts: start of codestream, then SIZ.
const std::uint8_t* FindCodestream(const std::vector<std::uint8_t>& bytes)
{
  constexpr std::array<std::uint8_t, 4> Start{0xFF, 0x4F, 0xFF, 0x51};
  const auto found = std::search(bytes.begin(), bytes.end(), Start.begin(), Start.end());
  return bytes.data() + (found - bytes.begin());
}

bool ReadImageSize(const Codestream& stream, ImageSize& size)
{
  constexpr std::size_t FirstField = 8;
  constexpr std::size_t EndOfSizes = FirstField + 34;
  if (stream.Size < EndOfSizes)
  {
    return false;
  }
  // Xsiz, Ysiz, XOsiz, YOsiz, XTsiz, YTsiz, XTOsiz, YTOsiz.
  std::array<std::uint64_t, 8> field{};
  for (std::size_t i = 0; i < field.size(); ++i)
  {
    field[i] = Number(stream.Bytes + FirstField + 4 * i, 4);
  }
  if (field[0] <= field[2] || field[1] <= field[3] || field[4] == 0 || field[5] == 0 ||
      field[6] > field[2] || field[7] > field[3])
  {
    return false;
  }
  const auto tiles = [&](std::size_t axis)
  { return (field[axis] - field[6 + axis] + field[4 + axis] - 1) / field[4 + axis]; };
  size = {field[0] - field[2], field[1] - field[3], tiles(0) * tiles(1),
          static_cast<int>(Number(stream.Bytes + FirstField + 32, 2))};
  return true;
}

// OpenJPEG allocates some kilobytes per declared tile: about a byte per pixel if tiles have at
// least 32 x 32 pixels.
bool Fits(const ImageSize& size, const CompressedFrame& frame)
{
  return size.Columns == static_cast<std::uint64_t>(frame.Columns) &&
         size.Rows == static_cast<std::uint64_t>(frame.Rows) && size.Components == 1 &&
         size.Tiles <= 1 + frame.PixelCount() / 1024;
}

ImagePointer Decode(Codestream& source)
{
  const StreamPointer stream = OpenStream(source);
  const CodecPointer codec(opj_create_decompress(OPJ_CODEC_J2K), &opj_destroy_codec);
  ImagePointer image(nullptr, &opj_image_destroy);
  opj_dparameters_t parameters;
  opj_set_default_decoder_parameters(&parameters);
  if (!stream || !codec || !opj_setup_decoder(codec.get(), &parameters))
  {
    return image;
  }
  opj_image_t* header = nullptr;
  const bool isRead = opj_read_header(stream.get(), codec.get(), &header);
  image.reset(header);
  if (!isRead || !opj_decode(codec.get(), stream.get(), image.get()) ||
      !opj_end_decompress(codec.get(), stream.get()))
  {
    image.reset();
  }
  return image;
}

bool Fits(const opj_image_t& image, const CompressedFrame& frame)
{
  return image.numcomps == 1 && image.comps[0].data &&
         image.comps[0].w == static_cast<OPJ_UINT32>(frame.Columns) &&
         image.comps[0].h == static_cast<OPJ_UINT32>(frame.Rows) && image.comps[0].prec >= 1 &&
         image.comps[0].prec <= static_cast<OPJ_UINT32>(8 * frame.BytesPerPixel);
}
} // namespace

bool DecodeJpeg2000(const CompressedFrame& frame, std::uint8_t* pixels)
{
  const std::uint8_t* start = FindCodestream(frame.Stream);
  Codestream source{start,
                    frame.Stream.size() - static_cast<std::size_t>(start - frame.Stream.data())};
  ImageSize size{};
  if (!ReadImageSize(source, size) || !Fits(size, frame))
  {
    return false;
  }
  const ImagePointer image = Decode(source);
  if (!image || !Fits(*image, frame))
  {
    return false;
  }
  const opj_image_comp_t& samples = image->comps[0];
  for (std::size_t i = 0; i < frame.PixelCount(); ++i)
  {
    frame.Store(static_cast<std::uint32_t>(samples.data[i]), static_cast<int>(samples.prec), i,
                pixels);
  }
  return true;
}
} // namespace palpate
