#include "CompressedDicom.h"

#include "QuietStandardStreams.h"

#include <algorithm>
#include <memory>
#include <openjpeg.h>
#include <stdexcept>

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcpixseq.h"
#include "dcmtk/dcmdata/dcpxitem.h"
#include "dcmtk/dcmdata/dcrleerg.h"
#include "dcmtk/dcmdata/dctk.h"
#include "dcmtk/dcmjpeg/djencode.h"
#include "dcmtk/dcmjpeg/djrplol.h"
#include "dcmtk/dcmjpeg/djrploss.h"
#include "dcmtk/dcmjpls/djencode.h"
#include "dcmtk/dcmjpls/djrparam.h"

namespace palpate::test
{
namespace
{
void Require(bool good, const char* what)
{
  if (!good)
  {
    throw std::runtime_error(what);
  }
}

E_TransferSyntax SyntaxOf(Codec codec)
{
  switch (codec)
  {
  case Codec::RunLength:
    return EXS_RLELossless;
  case Codec::JpegBaseline:
    return EXS_JPEGProcess1;
  case Codec::JpegExtended:
    return EXS_JPEGProcess2_4;
  case Codec::JpegLossless:
    return EXS_JPEGProcess14SV1;
  case Codec::JpegLs:
    return EXS_JPEGLSLossless;
  case Codec::JpegLsNearLossless:
    return EXS_JPEGLSLossy;
  case Codec::Jpeg2000:
    return EXS_JPEG2000LosslessOnly;
  case Codec::Jpeg2000Lossy:
    break;
  }
  return EXS_JPEG2000;
}

std::unique_ptr<DcmRepresentationParameter> ParameterOf(Codec codec)
{
  switch (codec)
  {
  case Codec::JpegBaseline:
  case Codec::JpegExtended:
    return std::make_unique<DJ_RPLossy>(95);
  case Codec::JpegLossless:
    return std::make_unique<DJ_RPLossless>();
  case Codec::JpegLs:
    return std::make_unique<DJLSRepresentationParameter>(2, OFTrue);
  case Codec::JpegLsNearLossless:
    return std::make_unique<DJLSRepresentationParameter>(2, OFFalse);
  default:
    return nullptr;
  }
}

// Registers DCMTK's encoders during its lifetime.
class Encoders
{
public:
  // "Cooked" JPEG-LS has BitsStored bits, but DCMTK fails an assertion when it cooks a negative
  // value; uncooked, it has BitsAllocated bits.
  explicit Encoders(bool isSigned)
  {
    DcmRLEEncoderRegistration::registerCodecs();
    DJEncoderRegistration::registerCodecs(ECC_monochrome, EUC_never);
    DJLSEncoderRegistration::registerCodecs(0, 0, 0, 0, !isSigned);
  }
  Encoders(const Encoders&) = delete;
  Encoders& operator=(const Encoders&) = delete;
  ~Encoders()
  {
    DcmRLEEncoderRegistration::cleanup();
    DJEncoderRegistration::cleanup();
    DJLSEncoderRegistration::cleanup();
  }
};

void Load(DcmFileFormat& format, const std::filesystem::path& file)
{
  Require(format.loadFile(file.c_str()).good(), "cannot load");
  Require(format.loadAllDataIntoMemory().good(), "cannot load");
}

DcmPixelItem* NewItem(const void* bytes, std::size_t count)
{
  auto item = std::make_unique<DcmPixelItem>(DcmTag(DCM_Item, EVR_OB));
  if (count > 0)
  {
    // Fragments have an even length.
    std::vector<Uint8> even(static_cast<const Uint8*>(bytes),
                            static_cast<const Uint8*>(bytes) + count);
    even.resize((count + 1) / 2 * 2, 0);
    Require(item->putUint8Array(even.data(), even.size()).good(), "cannot put a fragment");
  }
  return item.release();
}

void PutFragments(DcmDataset& dataset, E_TransferSyntax syntax,
                  const std::vector<std::string>& fragments,
                  const std::vector<std::uint32_t>& offsets)
{
  auto sequence = std::make_unique<DcmPixelSequence>(DcmTag(DCM_PixelData, EVR_OB));
  sequence->insert(NewItem(offsets.data(), 4 * offsets.size()));
  for (const std::string& fragment : fragments)
  {
    sequence->insert(NewItem(fragment.data(), fragment.size()));
  }
  auto pixels = std::make_unique<DcmPixelData>(DcmTag(DCM_PixelData, EVR_OB));
  pixels->putOriginalRepresentation(syntax, nullptr, sequence.release());
  Require(dataset.insert(pixels.release(), OFTrue).good(), "cannot put pixels");
}

int Number(DcmItem& item, const DcmTagKey& tag)
{
  Uint16 value = 0;
  Require(item.findAndGetUint16(tag, value).good(), "an attribute is absent");
  return value;
}

// Sign-extended values of uncompressed pixels, all frames.
std::vector<int> Values(DcmItem& item)
{
  const int bits = Number(item, DCM_BitsStored);
  const Uint8* bytes = nullptr;
  const Uint16* words = nullptr;
  unsigned long count = 0;
  if (item.findAndGetUint16Array(DCM_PixelData, words, &count).good())
  {
    bytes = reinterpret_cast<const Uint8*>(words);
    count *= 2;
  }
  else
  {
    Require(item.findAndGetUint8Array(DCM_PixelData, bytes, &count).good(), "no pixels");
  }
  std::vector<int> values;
  const unsigned long step = Number(item, DCM_BitsAllocated) == 8 ? 1 : 2;
  for (unsigned long i = 0; i + step <= count; i += step)
  {
    const int value = (step == 1 ? bytes[i] : bytes[i] | bytes[i + 1] << 8) & ((1 << bits) - 1);
    const bool isNegative = Number(item, DCM_PixelRepresentation) == 1 && value >> (bits - 1) != 0;
    values.push_back(isNegative ? value - (1 << bits) : value);
  }
  return values;
}

void CompressWithOpenJpeg(DcmDataset& dataset, Codec codec)
{
  const std::vector<int> values = Values(dataset);
  const int columns = Number(dataset, DCM_Columns);
  const int rows = Number(dataset, DCM_Rows);
  Sint32 frames = 1;
  if (dataset.findAndGetSint32(DCM_NumberOfFrames, frames).bad())
  {
    frames = 1;
  }
  std::vector<std::string> streams;
  for (int frame = 0; frame < frames; ++frame)
  {
    const auto first = values.begin() + frame * columns * rows;
    streams.push_back(Jpeg2000Stream(
        {first, first + columns * rows}, columns, rows, Number(dataset, DCM_BitsStored),
        Number(dataset, DCM_PixelRepresentation) == 1, codec == Codec::Jpeg2000Lossy ? 2 : 1));
  }
  PutFragments(dataset, SyntaxOf(codec), streams, {});
}

OPJ_SIZE_T Append(void* bytes, OPJ_SIZE_T count, void* user)
{
  static_cast<std::string*>(user)->append(static_cast<const char*>(bytes), count);
  return count;
}

opj_image_t* NewImage(const std::vector<int>& values, int columns, int rows, int precision,
                      bool isSigned)
{
  opj_image_cmptparm_t form{};
  form.dx = 1;
  form.dy = 1;
  form.w = static_cast<OPJ_UINT32>(columns);
  form.h = static_cast<OPJ_UINT32>(rows);
  form.prec = static_cast<OPJ_UINT32>(precision);
  form.sgnd = isSigned ? 1 : 0;
  opj_image_t* image = opj_image_create(1, &form, OPJ_CLRSPC_GRAY);
  image->x1 = form.w;
  image->y1 = form.h;
  std::copy(values.begin(), values.end(), image->comps[0].data);
  return image;
}
} // namespace

const char* CodecName(Codec codec)
{
  return DcmXfer(SyntaxOf(codec)).getXferName();
}

void Compress(const std::filesystem::path& file, Codec codec)
{
  const QuietStandardStreams quiet;
  DcmFileFormat format;
  Load(format, file);
  const E_TransferSyntax syntax = SyntaxOf(codec);
  if (codec == Codec::Jpeg2000 || codec == Codec::Jpeg2000Lossy)
  {
    CompressWithOpenJpeg(*format.getDataset(), codec);
  }
  else
  {
    const Encoders encoders(Number(*format.getDataset(), DCM_PixelRepresentation) == 1);
    const auto parameter = ParameterOf(codec);
    Require(format.getDataset()->chooseRepresentation(syntax, parameter.get()).good(),
            "cannot compress");
  }
  Require(format.saveFile(file.c_str(), syntax).good(), "cannot save");
}

std::vector<std::string> Fragments(const std::filesystem::path& file)
{
  DcmFileFormat format;
  Load(format, file);
  DcmElement* element = nullptr;
  format.getDataset()->findAndGetElement(DCM_PixelData, element);
  DcmPixelSequence* sequence = nullptr;
  auto* pixels = dynamic_cast<DcmPixelData*>(element);
  Require(pixels && pixels
                        ->getEncapsulatedRepresentation(format.getDataset()->getOriginalXfer(),
                                                        nullptr, sequence)
                        .good(),
          "no fragments");
  std::vector<std::string> fragments;
  for (unsigned long i = 1; i < sequence->card(); ++i)
  {
    DcmPixelItem* item = nullptr;
    Uint8* bytes = nullptr;
    sequence->getItem(item, i);
    item->getUint8Array(bytes);
    fragments.emplace_back(reinterpret_cast<const char*>(bytes), item->getLength());
  }
  return fragments;
}

void ReplaceFragments(const std::filesystem::path& file, const std::vector<std::string>& fragments,
                      const std::vector<std::uint32_t>& offsets)
{
  DcmFileFormat format;
  Load(format, file);
  const E_TransferSyntax syntax = format.getDataset()->getOriginalXfer();
  PutFragments(*format.getDataset(), syntax, fragments, offsets);
  Require(format.saveFile(file.c_str(), syntax).good(), "cannot save");
}

void StateTransferSyntax(const std::filesystem::path& file, const std::string& uid)
{
  const QuietStandardStreams quiet;
  DcmFileFormat format;
  Load(format, file);
  Require(format.getMetaInfo()->putAndInsertString(DCM_TransferSyntaxUID, uid.c_str()).good(),
          "cannot put a transfer syntax");
  Require(format
              .saveFile(file.c_str(), format.getDataset()->getOriginalXfer(), EET_UndefinedLength,
                        EGL_recalcGL, EPD_noChange, 0, 0, EWM_dontUpdateMeta)
              .good(),
          "cannot save");
}

std::string Jpeg2000Stream(const std::vector<int>& values, int columns, int rows, int precision,
                           bool isSigned, int ratio)
{
  std::string bytes;
  const std::unique_ptr<opj_image_t, decltype(&opj_image_destroy)> image(
      NewImage(values, columns, rows, precision, isSigned), &opj_image_destroy);
  const std::unique_ptr<opj_codec_t, decltype(&opj_destroy_codec)> codec(
      opj_create_compress(OPJ_CODEC_J2K), &opj_destroy_codec);
  const std::unique_ptr<opj_stream_t, decltype(&opj_stream_destroy)> stream(
      opj_stream_default_create(OPJ_FALSE), &opj_stream_destroy);
  opj_stream_set_write_function(stream.get(), &Append);
  opj_stream_set_user_data(stream.get(), &bytes, nullptr);
  opj_cparameters_t parameters;
  opj_set_default_encoder_parameters(&parameters);
  // OpenJPEG does not halve the image below one pixel.
  parameters.numresolution = std::min(columns, rows) < 4 ? 2 : 3;
  parameters.tcp_numlayers = 1;
  parameters.cp_disto_alloc = 1;
  parameters.irreversible = ratio > 1 ? 1 : 0;
  parameters.tcp_rates[0] = ratio > 1 ? static_cast<float>(ratio) : 0.0F;
  Require(opj_setup_encoder(codec.get(), &parameters, image.get()) &&
              opj_start_compress(codec.get(), image.get(), stream.get()) &&
              opj_encode(codec.get(), stream.get()) && opj_end_compress(codec.get(), stream.get()),
          "cannot encode JPEG 2000");
  return bytes;
}
} // namespace palpate::test
