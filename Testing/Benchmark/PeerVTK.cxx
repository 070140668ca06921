// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerVTK.h"

#include <vtkDijkstraGraphGeodesicPath.h>
#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkPolyData.h>

#include <cmath>

PeerVTK::PeerVTK(vtkPolyData* mesh)
{
  this->Filter->SetInputData(mesh);
  this->Run(0);
}

PeerVTK::~PeerVTK() = default;

void PeerVTK::Run(vtkIdType source)
{
  this->Filter->StopWhenEndReachedOff();
  this->Filter->SetStartVertex(source);
  // Only distances are needed: with the source as end vertex, the traced path is the shortest
  // possible.
  this->Filter->SetEndVertex(source);
  this->Filter->Modified();
  this->Filter->Update();
}

double PeerVTK::FindPath(vtkIdType from, vtkIdType to)
{
  this->Filter->StopWhenEndReachedOn();
  this->Filter->SetStartVertex(from);
  this->Filter->SetEndVertex(to);
  this->Filter->Modified();
  this->Filter->Update();
  vtkPolyData* path = this->Filter->GetOutput();
  double length = 0.0;
  for (vtkIdType i = 1; i < path->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    path->GetPoint(i - 1, p);
    path->GetPoint(i, q);
    length += std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
  }
  return length;
}

std::vector<double> PeerVTK::GetDistances()
{
  vtkNew<vtkDoubleArray> weights;
  this->Filter->GetCumulativeWeights(weights);
  const double* begin = weights->GetPointer(0);
  return std::vector<double>(begin, begin + weights->GetNumberOfTuples());
}
