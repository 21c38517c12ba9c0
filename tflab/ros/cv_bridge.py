"""Convert images between messages and NumPy arrays, as cv_bridge does, without OpenCV.

    "bgr8", "rgb8"            (height, width, 3) of uint8
    "mono8", "mono16"         (height, width)
    "16UC1", "32FC1", "8UC4"  plain types: bits, kind and channels

Colour is converted between bgr8, rgb8 and mono8. Compressed images are not supported.
"""

from __future__ import annotations

import re

import numpy as np

from .messages.sensor_msgs import Image
from .messages.std_msgs import Header

__all__ = ["CvBridge", "CvBridgeError"]

KINDS = {"U": "uint", "S": "int", "F": "float"}
COLOURS = {"mono8": "8UC1", "mono16": "16UC1", "bgr8": "8UC3", "rgb8": "8UC3"}
BGR_TO_GREY = (1868, 9617, 4899)  # OpenCV's weights, of 2**14


class CvBridgeError(TypeError):
    """The image cannot be converted."""


class CvBridge:
    """Converts images; a CvBridgeError says that there is no such encoding or conversion."""

    def imgmsg_to_cv2(self, img_msg: Image, desired_encoding: str = "passthrough") -> np.ndarray:
        """Return the pixels of a message."""
        dtype, channels = _type_of(img_msg.encoding)
        stored = dtype.newbyteorder(">" if img_msg.is_bigendian else "<")
        shape, strides = (img_msg.height, img_msg.width * channels), (img_msg.step, dtype.itemsize)
        image = np.ndarray(shape, stored, bytes(img_msg.data), 0, strides).astype(dtype)
        image = image if channels == 1 else image.reshape(img_msg.height, img_msg.width, channels)
        return image if desired_encoding == "passthrough" else _converted(image, img_msg.encoding, desired_encoding)

    def cv2_to_imgmsg(self, cvim: np.ndarray, encoding: str = "passthrough", header: Header | None = None) -> Image:
        """Return a message with these pixels."""
        if not isinstance(cvim, np.ndarray):
            raise TypeError("Your input type is not a numpy array")
        channels = cvim.shape[2] if cvim.ndim > 2 else 1
        cv_type = f"{cvim.dtype.itemsize * 8}{cvim.dtype.kind.upper().replace('I', 'S')}C{channels}"
        encoding = cv_type if encoding == "passthrough" else encoding
        if _type_of(cv_type) != _type_of(encoding):
            raise CvBridgeError(f"encoding specified as {encoding}, but image has incompatible type {cv_type}")
        message = Image(height=cvim.shape[0], width=cvim.shape[1], encoding=encoding, header=header or Header())
        message.is_bigendian = cvim.dtype.byteorder == ">"
        message.data.frombytes(cvim.tobytes())
        message.step = len(message.data) // message.height
        return message


def _type_of(encoding: str) -> tuple[np.dtype, int]:
    """Return the type of one number of an encoding, and the number of channels."""
    match = re.fullmatch(r"(8U|8S|16U|16S|32S|32F|64F)(?:C(\d+))?", COLOURS.get(encoding, encoding))
    if match is None:
        raise CvBridgeError(f"Unrecognized image encoding [{encoding}]")
    return np.dtype(f"{KINDS[match[1][-1]]}{match[1][:-1]}"), int(match[2] or 1)


def _converted(image: np.ndarray, source: str, target: str) -> np.ndarray:
    has_same_type = _type_of(source) == _type_of(target)
    if source == target or (has_same_type and target not in COLOURS):
        return image
    if source not in COLOURS and target in COLOURS:
        raise CvBridgeError(f"[{source}] is not a color format. but [{target}] is. The conversion does not make sense")
    if source in COLOURS and target not in COLOURS:
        must = "is not so they must have the same OpenCV type, CV_8UC3, CV16UC1 ...."
        raise CvBridgeError(f"[{source}] is a color format but [{target}] {must}")
    if "mono16" in (source, target) or target not in COLOURS:
        raise CvBridgeError(f"Unsupported conversion from [{source}] to [{target}]")
    if source == "mono8":
        return np.repeat(image[..., None], 3, axis=2)
    if target == "mono8":
        bgr = image if source == "bgr8" else image[..., ::-1]
        return ((bgr.astype(int) @ BGR_TO_GREY + 2**13) >> 14).astype(np.uint8)
    return image[..., ::-1].copy()
