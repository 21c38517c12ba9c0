"""tf_transformations and cv_bridge, which nodes import beside rclpy, give what they give on a robot."""

import numpy as np
import pytest

import tflab.ros
from tflab.ros.cv_bridge import CvBridge, CvBridgeError

P, Q = (0.1, 0.2, 0.3, 0.9), (0.5, -0.5, 0.5, -0.5)
BGR = np.uint8([[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [10, 20, 30]]])


@pytest.fixture(autouse=True)
def in_process():
    tflab.ros.activate("in-process")
    yield
    tflab.ros.deactivate()


@pytest.mark.parametrize(
    ("function", "arguments", "recorded"),  # tf_transformations 1.1.1 with transforms3d 0.4.2
    [
        ("quaternion_from_euler", (0.3, 0.4, -0.7), [0.2049, 0.1343, -0.3602, 0.9001]),
        ("quaternion_from_euler", (0.3, 0.4, -0.7, "rxyz"), [0.0702, 0.2347, -0.3044, 0.9205]),
        ("quaternion_from_euler", (0.3, 0.4, -0.7, "ryxy"), [0.1743, -0.1947, -0.0952, 0.9605]),
        ("euler_from_quaternion", (P,), [0.3393, 0.3213, 0.6990]),
        ("euler_from_quaternion", (P, "rzyx"), [0.6990, 0.3213, 0.3393]),
        ("euler_from_quaternion", (P, "szxz"), [-0.7854, 0.4630, 1.4289]),
        ("euler_from_quaternion", (P, "ryxy"), [2.1112, -0.6608, -1.6739]),
        ("quaternion_slerp", (P, Q, 0.25), [-0.0725, 0.3313, 0.1001, 0.9354]),
        ("quaternion_slerp", (P, Q, 0.25, 1, False), [-0.4436, 0.6479, -0.3073, 1.1246]),
        ("quaternion_inverse", ((0.1, 0.2, 0.3, 2.0),), [-0.0242, -0.0483, -0.0725, 0.4831]),
        ("quaternion_multiply", (P, Q), [0.65, -0.45, 0.15, -0.55]),
    ],
)  # fmt: skip
def test_transformations_are_those_of_tf_transformations(function, arguments, recorded):
    import tf_transformations

    assert np.asarray(getattr(tf_transformations, function)(*arguments)) == pytest.approx(np.array(recorded), abs=1e-4)


@pytest.mark.parametrize(
    ("encoding", "desired", "expected"),
    [
        ("bgr8", "passthrough", BGR),
        ("bgr8", "rgb8", BGR[..., ::-1]),
        ("rgb8", "mono8", [[76, 150], [29, 18]]),
        ("mono8", "bgr8", np.stack([BGR[..., 0]] * 3, axis=-1)),
        ("16UC1", "passthrough", BGR[..., 0]),
        ("32FC1", "32FC1", BGR[..., 0]),
        ("16UC1", "bgr8", r"\[16UC1\] is not a color format. but \[bgr8\] is."),
        ("bgr8", "32FC1", r"\[bgr8\] is a color format but \[32FC1\] is not"),
        ("bgr8", "grey", r"Unrecognized image encoding \[grey\]"),
        ("32FC3", "passthrough", "encoding specified as 32FC3, but image has incompatible type 32FC1"),
    ],
)
def test_images_go_to_numpy_and_back(encoding, desired, expected):
    image = BGR if encoding in ("bgr8", "rgb8") else BGR[..., 0]
    image = image.astype({"16": ">u2", "32": "f4"}.get(encoding[:2], "u1"))

    def there_and_back():
        return CvBridge().imgmsg_to_cv2(CvBridge().cv2_to_imgmsg(image, encoding), desired)

    if isinstance(expected, str):
        with pytest.raises(CvBridgeError, match=expected):
            there_and_back()
    else:
        assert there_and_back().tolist() == np.asarray(expected).tolist()
