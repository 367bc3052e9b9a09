#pragma once

#include "Mutation.h"

namespace palpate::test
{
/// Changes values by their representation, tags, representations, lengths, sequences and nesting
/// of a DICOM file.
void MutateDicom(std::string& bytes, Random& random);

/// Changes the compressed frames of a DICOM file: segments, lengths and parameters of JPEG, JPEG-LS
/// and JPEG 2000 streams, offsets of run-length coded ones. The length fields around them are
/// updated.
void MutateFrames(std::string& bytes, Random& random);
} // namespace palpate::test
