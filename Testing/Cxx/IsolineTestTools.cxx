// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsolineTestTools.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dggtest
{
namespace
{
/// How far a point is beyond the sides of a triangle or off its plane, in its longest edge.
double GetExcess(const double corners[3][3], const double p[3])
{
  double edges[3][3];
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    vtkMath::Subtract(corners[(k + 1) % 3], corners[k], edges[k]);
    longest = std::max(longest, vtkMath::Norm(edges[k]));
  }
  double normal[3];
  vtkMath::Cross(edges[0], edges[1], normal);
  vtkMath::Normalize(normal);
  double excess = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    double way[3];
    double inside[3];
    vtkMath::Subtract(p, corners[k], way);
    vtkMath::Cross(normal, edges[k], inside);
    vtkMath::Normalize(inside);
    excess = std::max({ excess, -vtkMath::Dot(way, inside), std::abs(vtkMath::Dot(way, normal)) });
  }
  return excess / longest;
}
}

vtkIdType ExpectPiecesInTheirFaces(vtkPolyData* surface, vtkPolyData* lines)
{
  vtkDataArray* faces = lines->GetPointData()->GetArray("FaceId");
  EXPECT_NE(faces, nullptr);
  vtkIdType count = 0;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> cornerIds;
  for (vtkIdType line = 0; faces && line < lines->GetNumberOfCells(); ++line)
  {
    lines->GetCellPoints(line, ids);
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i, ++count)
    {
      const auto face = static_cast<vtkIdType>(faces->GetComponent(ids->GetId(i), 0));
      surface->GetCellPoints(face, cornerIds);
      double corners[3][3];
      for (int k = 0; k < 3; ++k)
      {
        surface->GetPoint(cornerIds->GetId(k), corners[k]);
      }
      double p[3];
      double q[3];
      lines->GetPoint(ids->GetId(i), p);
      lines->GetPoint(ids->GetId(i + 1), q);
      const double middle[] = { 0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]) };
      const double* places[] = { p, middle, q };
      for (const double* place : places)
      {
        EXPECT_LE(GetExcess(corners, place), 1e-9)
          << "line " << line << ", piece " << i << ", face " << face;
      }
    }
  }
  return count;
}
}
