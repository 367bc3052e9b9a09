/**
 * @class vtkSegmentationReader
 * @brief reads a segmentation: one layer of labels as an image, and the list of its segments
 *
 * Reads label maps (NIfTI, NRRD, MetaImage), 3D Slicer's .seg.nrrd and DICOM segmentation objects.
 * The output is one layer, as unsigned char, unsigned short or int, named "Labels", with origin,
 * spacing (mm) and a right-handed direction matrix in patient LPS. The file is read in the
 * information pass, and again when its name changes; choosing another layer does not read it again.
 * A file that cannot be read raises one ErrorEvent and produces no output. See
 * palpate::ReadSegmentation.
 */
#ifndef vtkSegmentationReader_h
#define vtkSegmentationReader_h

#include "PalpateIOModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For the segmentation that is kept

class PALPATEIO_EXPORT vtkSegmentationReader : public vtkImageAlgorithm
{
public:
  static vtkSegmentationReader* New();
  vtkTypeMacro(vtkSegmentationReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Segmentation file, or a folder with one DICOM segmentation object. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** The output layer, from 0. Structures that overlap are in different layers. */
  vtkSetMacro(Layer, int);
  vtkGetMacro(Layer, int);
  ///@}

  ///@{
  /**
   * The segments by index, in the order of their labels; valid after UpdateInformation. The label
   * identifies a segment; its value is that of its voxels in its layer. Out of range: -1, null,
   * grey.
   */
  int GetNumberOfLayers();
  int GetNumberOfSegments();
  int GetSegmentLabel(int index);
  int GetSegmentValue(int index);
  int GetSegmentLayer(int index);
  const char* GetSegmentName(int index);
  void GetSegmentColor(int index, double color[3]);
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
  /** Changes made to the file's data, one message each. Valid after UpdateInformation. */
  int GetNumberOfNotes();
  const char* GetNote(int index);
  ///@}

protected:
  vtkSegmentationReader();
  ~vtkSegmentationReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkSegmentationReader(const vtkSegmentationReader&) = delete;
  void operator=(const vtkSegmentationReader&) = delete;

  bool ReadFile();

  char* FileName = nullptr;
  bool RefuseLeftHanded = false;
  int Layer = 0;
  struct ReadState;
  std::unique_ptr<ReadState> State;
};

#endif
