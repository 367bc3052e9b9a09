/**
 * @class vtkOrientedVolumeReader
 * @brief reads a medical volume with its direction matrix
 *
 * Reads NIfTI, NRRD, MetaImage, or a DICOM series (its folder or one of its files). The output
 * carries origin, spacing (mm) and a right-handed direction matrix in patient LPS, and scalars of
 * the file's type. The file is read in the information pass, and again when its name or series
 * changes. A file that cannot be read raises one ErrorEvent and produces no output. See
 * palpate::ReadVolume.
 */
#ifndef vtkOrientedVolumeReader_h
#define vtkOrientedVolumeReader_h

#include "PalpateIOModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For the volume that is kept

class PALPATEIO_EXPORT vtkOrientedVolumeReader : public vtkImageAlgorithm
{
public:
  static vtkOrientedVolumeReader* New();
  vtkTypeMacro(vtkOrientedVolumeReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** File, or folder of a DICOM series. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** Series of a DICOM folder: its UID or its number in the error message's list, from 1. */
  vtkSetStringMacro(Series);
  vtkGetStringMacro(Series);
  ///@}

  ///@{
  /**
   * Refuse a file with left-handed directions. Off by default: such a file is read with one index
   * axis reversed, every voxel keeps its position, and a note is added.
   */
  vtkSetMacro(RefuseLeftHanded, bool);
  vtkGetMacro(RefuseLeftHanded, bool);
  vtkBooleanMacro(RefuseLeftHanded, bool);
  ///@}

  ///@{
  /** Changes made to the file's data, a sentence each. Valid after UpdateInformation. */
  int GetNumberOfNotes();
  const char* GetNote(int index);
  ///@}

protected:
  vtkOrientedVolumeReader();
  ~vtkOrientedVolumeReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkOrientedVolumeReader(const vtkOrientedVolumeReader&) = delete;
  void operator=(const vtkOrientedVolumeReader&) = delete;

  char* FileName = nullptr;
  bool RefuseLeftHanded = false;
  char* Series = nullptr;
  struct ReadState;
  std::unique_ptr<ReadState> State;
};

#endif
