"""A subject with determinants by numpy (LU factorisation in doubles).

    homeo fuzz orient3d --binary --subject "python3 reference/subjects/numpy_det.py --binary"
"""

import warnings

import numpy as np
from protocol import points, serve, sign

warnings.filterwarnings("ignore")


def orient(dimension):
    def answer(case):
        p = np.array(points(case, dimension))
        return sign(float(np.linalg.det(p[1:] - p[0])))

    return answer


serve({"orient2d": orient(2), "orient3d": orient(3)})
