// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StrictImageComparison.h"

#include "vtkImageDifference.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace dggtest
{
namespace
{
/// Returns the image closest to `image` among <stem>.png, <stem>_1.png, <stem>_2.png and so on;
/// null if there is none.
vtkSmartPointer<vtkImageData> ReadClosestBaseline(vtkImageData* image, const std::string& stem)
{
  vtkSmartPointer<vtkImageData> closest;
  std::string file = stem + ".png";
  for (int i = 1; vtkNew<vtkPNGReader>()->CanReadFile(file.c_str()) != 0; ++i)
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    if (!closest || CompareImages(image, reader->GetOutput()) < CompareImages(image, closest))
    {
      closest = reader->GetOutput();
    }
    file = stem + "_" + std::to_string(i) + ".png";
  }
  return closest;
}

/// Returns an image of the same size whose pixel (x, y) is the pixel source(x, y).
template <typename Source>
vtkSmartPointer<vtkImageData> Rearranged(vtkImageData* image, Source source)
{
  int size[3];
  image->GetDimensions(size);
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->DeepCopy(image);
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto from = source(x, y);
      for (int c = 0; c < image->GetNumberOfScalarComponents(); ++c)
      {
        result->SetScalarComponentFromDouble(
          x, y, 0, c, image->GetScalarComponentAsDouble(from.first, from.second, 0, c));
      }
    }
  }
  return result;
}
}

vtkSmartPointer<vtkImageData> Capture(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->SetInputBufferTypeToRGB();
  grabber->ReadFrontBufferOff();
  grabber->Update();
  return grabber->GetOutput();
}

double CompareImages(vtkImageData* image, vtkImageData* baseline)
{
  int size[3];
  int baselineSize[3];
  image->GetDimensions(size);
  baseline->GetDimensions(baselineSize);
  if (!std::equal(size, size + 3, baselineSize) ||
    image->GetNumberOfScalarComponents() != baseline->GetNumberOfScalarComponents())
  {
    return std::numeric_limits<double>::infinity();
  }
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(image);
  difference->SetImageData(baseline);
  difference->AllowShiftOff();
  difference->AveragingOff();
  difference->SetThreshold(0);
  difference->Update();
  return difference->GetThresholdedError();
}

vtkSmartPointer<vtkImageData> Shifted(vtkImageData* image, int dx, int dy)
{
  int size[3];
  image->GetDimensions(size);
  return Rearranged(image, [&](int x, int y) {
    return std::make_pair(
      std::min(std::max(x - dx, 0), size[0] - 1), std::min(std::max(y - dy, 0), size[1] - 1));
  });
}

vtkSmartPointer<vtkImageData> Mirrored(vtkImageData* image, bool leftToRight)
{
  int size[3];
  image->GetDimensions(size);
  return Rearranged(image, [&](int x, int y) {
    return leftToRight ? std::make_pair(size[0] - 1 - x, y) : std::make_pair(x, size[1] - 1 - y);
  });
}

void ExpectBaseline(vtkRenderWindow* window, const std::string& name)
{
  auto image = Capture(window);
  const std::string written = std::string(DGG_TEST_OUTPUT) + "/" + name + ".png";
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(written.c_str());
  writer->SetInputData(image);
  writer->Write();

  const std::string stem = std::string(DGG_TEST_BASELINE) + "/" + name;
  auto baseline = ReadClosestBaseline(image, stem);
  ASSERT_NE(baseline, nullptr) << stem << ".png is missing. Look at " << written
                               << " and, when it is right, copy it there.";

  EXPECT_LE(CompareImages(image, baseline), ImageErrorBudget)
    << "compare " << written << " with " << stem << ".png and its alternatives";
  const double clearly = 10.0 * ImageErrorBudget;
  EXPECT_GT(CompareImages(Shifted(image, 1, 0), baseline), clearly);
  EXPECT_GT(CompareImages(Shifted(image, 0, 1), baseline), clearly);
  EXPECT_GT(CompareImages(Mirrored(image, true), baseline), clearly);
  EXPECT_GT(CompareImages(Mirrored(image, false), baseline), clearly);
}
}
