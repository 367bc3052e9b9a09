#include "DicomSurfaceWriter.h"

#include "DicomWriting.h"
#include "FileFormat.h"
#include "Refusal.h"
#include "SurfaceFile.h"
#include "TemporaryFile.h"
#include "WholeFile.h"

#include "vtkPolyData.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dctk.h"
#include <limits>

namespace palpate
{
namespace
{
std::string SurfaceBytesOf(const std::filesystem::path& path, vtkPolyData* surface,
                           const std::string& ending)
{
  TemporaryFile file;
  RequireInput(file.Create(path, ".palpate-", ending), path.string());
  WriteSurface(file.Path(), surface);
  constexpr std::uintmax_t Most = std::numeric_limits<std::uint32_t>::max() - 1;
  return ReadWholeFile(file.Path(), Most);
}
} // namespace

void WriteDicomSurface(const std::filesystem::path& path, vtkPolyData* surface,
                       const DicomSource& source)
{
  const bool isObj = !EndingOf(path, {".obj.dcm"}).empty();
  std::string bytes = SurfaceBytesOf(path, surface, isObj ? ".obj" : ".stl");
  const auto length = static_cast<Uint32>(bytes.size());
  bytes.resize((bytes.size() + 1) / 2 * 2, isObj ? '\n' : '\0');
  DcmFileFormat format;
  DcmItem& root = *format.getDataset();
  source.Describe(root, isObj ? UID_EncapsulatedOBJStorage : UID_EncapsulatedSTLStorage, "M3D");
  PutDicomText(root, DCM_AcquisitionDateTime, "");
  PutDicomText(root, DCM_BurnedInAnnotation, "NO");
  PutDicomText(root, DCM_DocumentTitle, "");
  PutDicomText(root, DCM_MIMETypeOfEncapsulatedDocument, isObj ? "model/obj" : "model/stl");
  root.insertEmptyElement(DCM_ConceptNameCodeSequence);
  for (const DicomSource::Slice& slice : source.Slices())
  {
    PutDicomReference(root, DCM_SourceInstanceSequence, slice.SopClass, slice.Instance);
  }
  PutDicomTerm(root, DCM_MeasurementUnitsCodeSequence, {"UCUM", "mm", "mm"});
  root.putAndInsertUint32(DCM_EncapsulatedDocumentLength, length);
  root.putAndInsertUint8Array(DCM_EncapsulatedDocument,
                              reinterpret_cast<const Uint8*>(bytes.data()), bytes.size());
  source.ReferenceAll(root);
  SaveDicom(path, format);
}
} // namespace palpate
