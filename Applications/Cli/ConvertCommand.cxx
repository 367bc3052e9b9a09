#include "ConvertCommand.h"

#include "Console.h"
#include "DicomSegmentationWriter.h"
#include "DicomSource.h"
#include "DicomStructureSetWriter.h"
#include "DicomSurfaceWriter.h"
#include "FileType.h"
#include "ImageContent.h"
#include "ImageFormat.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "Interruption.h"
#include "MaskFolder.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "Progress.h"
#include "SegmentationFile.h"
#include "SegmentationWriter.h"
#include "SurfaceFile.h"
#include "TouchTicksFile.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <CLI/CLI.hpp>

namespace palpate::cli
{
namespace
{
void PassOn(const std::vector<std::string>& notes, Console& console)
{
  for (const std::string& note : notes)
  {
    console.Note(note);
  }
}

// Checked before writing; a file is then written whole.
void RequireGoingOn()
{
  if (Interruption::WasAsked())
  {
    throw Cancelled();
  }
}

// One structure as a mask of 0 and 1 on its layer's grid (unsigned char).
vtkSmartPointer<vtkImageData> MaskOf(const Segmentation& segmentation, const Segment& structure)
{
  vtkImageData* layer = segmentation.Layers[static_cast<std::size_t>(structure.Layer)];
  vtkDataArray* values = layer->GetPointData()->GetScalars();
  vtkNew<vtkUnsignedCharArray> inside;
  inside->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    inside->SetValue(i, values->GetComponent(i, 0) == structure.Value ? 1 : 0);
  }
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->CopyStructure(layer);
  mask->GetPointData()->SetScalars(inside);
  return mask;
}

bool IsDicomOutput(const std::filesystem::path& path)
{
  return !EndingOf(path, {".dcm"}).empty();
}

Segmentation OnlyOf(const Segmentation& segmentation, Segment structure)
{
  Segmentation only;
  only.Layers = {MaskOf(segmentation, structure)};
  structure.Label = structure.Value = 1;
  structure.Layer = 0;
  only.Segments = {structure};
  return only;
}
} // namespace

std::string ConvertCommand::Examples() const
{
  return "  palpate convert model.json model.coef              for SPHARM-PDM\n"
         "  palpate convert hippocampus.coef surface.vtp       draw SPHARM-PDM coefficients\n"
         "  palpate convert model.json model.x3d --frequency 40\n"
         "  palpate convert surface.vtp surface.stl\n"
         "  palpate convert mask.nii.gz mask.nrrd\n"
         "  palpate convert mask.seg.nrrd gland.nii.gz --label Prostate\n"
         "  palpate convert labels.nii.gz labels.seg.nrrd      for 3D Slicer, with names and "
         "colours\n"
         "  palpate convert labels.seg.nrrd labels.txt         the names alone, for ITK-SNAP\n"
         "  palpate convert probability.nii.gz mask.nii.gz --threshold 0.5\n"
         "  palpate convert labels.nii.gz labels.dcm --source series   DICOM segmentation for a "
         "PACS\n"
         "  palpate convert labels.nii.gz rs.dcm --source series --contours   structure set\n"
         "  palpate convert tilted.nii.gz upright.nii.gz --resample\n"
         "  palpate convert mask.nii.gz moved.nii.gz --transform moved.tfm --reference "
         "scan.nii.gz\n"
         "  palpate convert masks labels.seg.nrrd              a folder of masks, named by file\n"
         "  palpate convert felt/session.touch ticks.csv       one line per tick";
}

void ConvertCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("IN", this->Input,
                 "Model, surface, image, segmentation, a folder of masks, or recorded touch")
      ->required()
      ->check(FileType::Input("file"));
  app.add_option("OUT", this->Output, "Output file; its ending selects the format")
      ->required()
      ->check(FileType::Output("file"));
  app.add_option("--label", this->Label,
                 "Write only this structure of a segmentation, as a mask of 0 and 1")
      ->type_name("N|NAME");
  app.add_option("--source", this->Source,
                 "DICOM series (its folder or one of its files) that the input was made on, for "
                 "output named .dcm: a segmentation, or a surface as encapsulated STL (.obj.dcm: "
                 "OBJ). Patient and study, with their names, are copied from this series and from "
                 "nowhere else")
      ->type_name("DICOM")
      ->check(FileType::Input("file"));
  app.add_flag("--contours", this->AsContours,
               "Write the structures to .dcm as contours (structure set) instead of voxels");
  this->Images.Declare(app, "folder");
  this->Images.DeclareValues(app);
  this->Images.DeclareResampling(app);
  this->Move.Declare(app);
  app.add_option("--frequency", this->Frequency,
                 "Subdivision F of the icosahedron for drawing a model: 20 F^2 triangles")
      ->check(CLI::Range(1, 200))
      ->capture_default_str();
}

int ConvertCommand::Run(Console& console)
{
  const Interruption interruption;
  this->Tally = {};
  const bool isWhole =
      IsModelFile(this->Input) || IsSurfaceFile(this->Input) || IsTouchRecording(this->Input);
  if (isWhole && !this->Label.empty())
  {
    throw InputError("--label needs a segmentation, which " + this->Input.string() +
                     " is not; leave it out");
  }
  this->CheckDicomOptions();
  if (IsTouchRecording(this->Input) && this->Move.IsGiven())
  {
    throw InputError("--transform moves no recorded touch; leave it out");
  }
  this->Move.Read(this->Input);
  if (IsModelFile(this->Input))
  {
    this->ConvertModel(console);
  }
  else if (IsSurfaceFile(this->Input))
  {
    if (!IsSurfaceFile(this->Output) && !IsDicomOutput(this->Output))
    {
      throw InputError(this->Output.string() + " is not a surface file, but " +
                       this->Input.string() + " is; use " +
                       ListOfEndings(SurfaceFormats().WrittenEndings()) +
                       ", or palpate fit on its mask for a model.");
    }
    const vtkSmartPointer<vtkPolyData> surface = this->Move.Moved(ReadSurface(this->Input));
    RequireGoingOn();
    this->WriteSurfaceTo(surface);
  }
  else if (IsTouchRecording(this->Input))
  {
    this->ConvertTouch(console);
  }
  else
  {
    this->ConvertImage(console);
  }
  return this->Tally.ExitCode();
}

void ConvertCommand::CheckDicomOptions() const
{
  if (IsDicomOutput(this->Output) && this->Source.empty())
  {
    throw InputError(this->Output.string() +
                     " is a DICOM file, which belongs to a patient and a study; name the series "
                     "that " +
                     this->Input.string() + " was made on by --source.");
  }
  if (!IsDicomOutput(this->Output) && (this->AsContours || !this->Source.empty()))
  {
    throw InputError("--source and --contours are for an output named .dcm, not " +
                     this->Output.string() + "; leave them out.");
  }
  if (this->AsContours && (IsModelFile(this->Input) || IsSurfaceFile(this->Input)))
  {
    throw InputError("--contours needs a segmentation, which " + this->Input.string() +
                     " is not; leave it out.");
  }
}

void ConvertCommand::WriteSurfaceTo(vtkPolyData* surface) const
{
  if (IsDicomOutput(this->Output))
  {
    WriteDicomSurface(this->Output, surface, DicomSource(this->Source));
    return;
  }
  WriteSurface(this->Output, surface);
}

void ConvertCommand::ConvertTouch(Console& console) const
{
  const auto goOn = [](double, const std::string&)
  {
    RequireGoingOn();
    return true;
  };
  if (ExportTouch(this->Input, this->Output, goOn))
  {
    console.Note(this->Input.string() + " ends within a tick, which is left out");
  }
}

void ConvertCommand::ConvertModel(Console& console) const
{
  ModelDocument document = ReadModel(this->Input);
  document.Surface = this->Move.Moved(document.Surface);
  RequireGoingOn();
  if (IsSurfaceFile(this->Output) || IsDicomOutput(this->Output))
  {
    this->WriteSurfaceTo(DrawModel(document.Surface, this->Frequency));
    return;
  }
  if (!IsModelFile(this->Output))
  {
    throw InputError(this->Output.string() + " is neither a model nor a surface file, but " +
                     this->Input.string() + " is a model; use " +
                     ListOfEndings(ReadableModelEndings()) + ", .csv or a surface format.");
  }
  WriteModel(this->Output, document);
  if (std::holds_alternative<RadialModel>(document.Surface) && !KeepsRadialModel(this->Output))
  {
    console.Note(this->Output.string() + " holds the same surface as a surface model of one "
                                         "degree more; its format cannot store the centre.");
  }
}

void ConvertCommand::ConvertImage(Console& console)
{
  const bool isSegmentation = IsLabelDescription(this->Output) || IsDicomOutput(this->Output) ||
                              IsSlicerSegmentation(this->Output);
  if (!IsWritableImage(this->Output) && !isSegmentation)
  {
    std::vector<std::string> endings = ImageFormats().WrittenEndings();
    endings.insert(endings.end(), {".seg.nrrd", ".dcm", ".txt", ".label"});
    throw InputError(this->Output.string() + " is not an image file that can be written, but " +
                     this->Input.string() + " is read as an image; use " + ListOfEndings(endings) +
                     ", or palpate mesh for a surface.");
  }
  if (IsMaskFolder(this->Input) || !this->Label.empty() || isSegmentation)
  {
    this->ConvertSegmentation(console);
    return;
  }
  const ImageContent content = ReadImageContent(this->Input, this->Images.Choice());
  RequireGoingOn();
  if (content.Image)
  {
    PassOn(content.Image->Notes, console);
    WriteImage(this->Output,
               this->Move.Moved(content.Image->Image,
                                content.Labels ? ResamplingKind::Nearest : ResamplingKind::Linear),
               content.Labels ? LabelsOf(*content.Labels) : LabelTable());
    return;
  }
  PassOn(content.Labels->Notes, console);
  WriteSegmentation(this->Output, this->Move.Moved(*content.Labels));
}

Segmentation ConvertCommand::ReadLabels(Console& console)
{
  if (!IsMaskFolder(this->Input))
  {
    Segmentation segmentation = ReadSegmentation(this->Input, this->Images.Choice());
    PassOn(segmentation.Notes, console);
    return segmentation;
  }
  const MaskFolder folder(this->Input, this->Images.Choice(), false,
                          [](std::size_t, std::size_t) { RequireGoingOn(); });
  // An empty or broken mask, or one on another grid, leaves the others.
  for (const RefusedMask& mask : folder.LeftOut())
  {
    ++this->Tally.Cases;
    ++this->Tally.BadInputs;
    console.Error(mask.Message);
  }
  this->Tally.Cases += static_cast<int>(folder.Count());
  PassOn(folder.Structures().Notes, console);
  return folder.Structures();
}

void ConvertCommand::ConvertSegmentation(Console& console)
{
  const Segmentation segmentation = this->ReadLabels(console);
  const Segmentation chosen = this->Move.Moved(
      this->Label.empty() ? segmentation : OnlyOf(segmentation, segmentation.Find(this->Label)));
  RequireGoingOn();
  if (!IsDicomOutput(this->Output))
  {
    WriteSegmentation(this->Output, chosen);
    return;
  }
  const DicomSource source(this->Source);
  const bool isExact = this->AsContours ? WriteDicomStructureSet(this->Output, chosen, source)
                                        : WriteDicomSegmentation(this->Output, chosen, source);
  if (!isExact)
  {
    console.Note(this->Input.string() + " does not have the voxels of the series; " +
                 (this->AsContours ? "contours follow its nearest ones."
                                   : "frames have its own, in the same frame of reference."));
  }
}
} // namespace palpate::cli
