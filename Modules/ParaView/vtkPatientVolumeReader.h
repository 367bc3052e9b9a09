#ifndef vtkPatientVolumeReader_h
#define vtkPatientVolumeReader_h

#include "PalpateParaViewModule.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

/// Reads an MR or CT volume (palpate::ReadVolume: NIfTI, NRRD, MetaImage, a DICOM series and
/// others) as an image with origin, spacing (mm) and a right-handed direction matrix in patient
/// LPS. The file is read in the information pass, and again when a setting changes. A file that
/// cannot be read raises an error and produces no output.
class PALPATEPARAVIEW_EXPORT vtkPatientVolumeReader : public vtkImageAlgorithm
{
public:
  static vtkPatientVolumeReader* New();
  vtkTypeMacro(vtkPatientVolumeReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ A file of the volume.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{ DICOM: the series' instance UID or its number; of a file of several volumes the number of
  /// one, from 1. Default: empty, for the only one.
  vtkSetMacro(Series, std::string);
  vtkGetMacro(Series, std::string);
  ///@}

protected:
  vtkPatientVolumeReader() { this->SetNumberOfInputPorts(0); }
  ~vtkPatientVolumeReader() override { this->SetFileName(nullptr); }

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkPatientVolumeReader(const vtkPatientVolumeReader&) = delete;
  void operator=(const vtkPatientVolumeReader&) = delete;

  char* FileName = nullptr;
  std::string Series;
  vtkSmartPointer<vtkImageData> Read;
  vtkTimeStamp ReadTime;
};

#endif
