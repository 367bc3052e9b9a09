#include "DicomTransferSyntax.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcxfer.h"

namespace palpate
{
PixelCoding PixelCodingOf(const std::string& transferSyntaxUid)
{
  const DcmXfer syntax(transferSyntaxUid.c_str());
  switch (syntax.getXfer())
  {
  case EXS_RLELossless:
    return PixelCoding::RunLength;
  case EXS_JPEGProcess1:
  case EXS_JPEGProcess2_4:
  case EXS_JPEGProcess14:
  case EXS_JPEGProcess14SV1:
    return PixelCoding::Jpeg;
  case EXS_JPEGLSLossless:
  case EXS_JPEGLSLossy:
    return PixelCoding::JpegLs;
  case EXS_JPEG2000LosslessOnly:
  case EXS_JPEG2000:
    return PixelCoding::Jpeg2000;
  case EXS_LittleEndianImplicit:
  case EXS_BigEndianImplicit:
  case EXS_LittleEndianExplicit:
  case EXS_BigEndianExplicit:
  case EXS_DeflatedLittleEndianExplicit:
  case EXS_PrivateGE_LEI_WithBigEndianPixelData:
    return PixelCoding::Native;
  default:
    return PixelCoding::Unread;
  }
}

std::string TransferSyntaxName(const std::string& transferSyntaxUid)
{
  // Newer than Debian 12's DCMTK: .201 to .203, and .204 and .205 through JPIP.
  if (transferSyntaxUid.rfind("1.2.840.10008.1.2.4.20", 0) == 0)
  {
    return "High-Throughput JPEG 2000 (" + transferSyntaxUid + ")";
  }
  const DcmXfer syntax(transferSyntaxUid.c_str());
  return syntax.getXfer() == EXS_Unknown
             ? transferSyntaxUid
             : std::string(syntax.getXferName()) + " (" + transferSyntaxUid + ")";
}
} // namespace palpate
