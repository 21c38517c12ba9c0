# %% [markdown] lang="en" name="title" slide="slide"
# # Glossary
#
# Every term of the course, in the order in which the chapters need them.
# On the pages, rest the pointer on a dotted word, or move to it with Tab, to read the same sentence.
# The Korean term is in brackets.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 용어집
#
# 이 워크북에 나오는 용어를 장의 순서대로 모았습니다.
# 본문에서 점선이 그어진 단어에 마우스를 올리거나 Tab으로 옮겨 가면 같은 설명이 나타납니다.

# %% [markdown] lang="en" name="index" slide="skip"
# In alphabetical order, each with the number of its chapter:
#
# authority 4 · bag 10 · base_footprint 5 · base_link 1 · body frame 2 · broadcaster 6 · buffer 8 · cache time 8 · callback 9 · child frame 3 · clock offset 9 · ConnectivityException 9 · decay time 11 · detector 2 · display status 11 · drift 5 · dynamic transform 6 · edge 4 · evidence 12 · executor 9 · extrapolation 8 · ExtrapolationException 9 · fixed frame 8 · forward kinematics 7 · frame 1 · frame prefix 4 · future 9 · gimbal lock 2 · header 1 · interpolation 8 · InvalidArgumentException 9 · inverse 3 · jitter 9 · joint 7 · latency 8 · latest common time 8 · link 7 · listener 8 · localization 5 · lookup 3 · LookupException 9 · map 5 · message 0 · message filter 9 · motion distortion 8 · namespace 4 · node 0 · odom 5 · odometry 5 · optical frame 2 · owner 11 · parent frame 3 · path 4 · point cloud 2 · pose 1 · publish 0 · QoS 6 · quaternion 2 · reentrant 9 · REP-103 2 · REP-105 5 · right-handed 2 · robot_state_publisher 7 · roll, pitch, yaw 2 · root 4 · rotation 2 · RViz 0 · sample 8 · second owner 12 · simulation time 10 · smear 8 · snapshot 11 · source frame 3 · stamp 1 · static transform 6 · suspect 12 · target frame 3 · tcp 7 · TF tree 4 · TF2 0 · tf2_echo 3 · tf2_monitor 11 · thread 9 · timeline 8 · timeout 9 · TimeoutException 9 · topic 0 · transform 3 · TransformException 9 · transient local 6 · translation 3 · transport delay 9 · TypeException 8 · unit quaternion 2 · URDF 7 · view_frames 4 · yaw 2

# %% [markdown] lang="ko" name="index" slide="skip"
# 가나다순으로 찾기(숫자는 그 용어를 설명한 장입니다):
#
# 검출기 2 · 경로 4 · 고정 좌표계 8 · 관절 7 · 광학 좌표계 2 · 네임스페이스 4 · 노드 0 · 단위 쿼터니언 2 · 동적 좌표 변환 6 · 두 번째 발행자 12 · 드리프트 5 · 디스플레이 상태 11 · 롤·피치·요 2 · 루트 4 · 링크 7 · 메시지 0 · 메시지 필터 9 · 목표 좌표계 3 · 발행 0 · 발행 책임 11 · 발행자 4 · 번짐 8 · 변환 발행기 6 · 변환 버퍼 8 · 변환 수신기 8 · 보간 8 · 보관 시간 8 · 본체 축 좌표계 2 · 부모 좌표계 3 · 스냅샷 11 · 스레드 9 · 시간줄 8 · 시계 차이 9 · 시뮬레이션 시간 10 · 실행기 9 · 역변환 3 · 연결 4 · 오도메트리 5 · 오른손 좌표계 2 · 외삽 8 · 요 2 · 용의자 12 · 움직임 왜곡 8 · 원본 좌표계 3 · 위치 추정 5 · 이동 3 · 자식 좌표계 3 · 재진입 9 · 전송 지연 9 · 전송 후 보존 6 · 접두사 4 · 정기구학 7 · 정적 좌표 변환 6 · 조회 3 · 좌표 변환 3 · 좌표계 1 · 증거 12 · 지연 8 · 지터 9 · 짐벌 락 2 · 최신 공통 시각 8 · 측정 시각 1 · 콜백 9 · 쿼터니언 2 · 토픽 0 · 포인트 클라우드 2 · 포즈 1 · 표본 8 · 표시 유지 시간 11 · 퓨처 9 · 헤더 1 · 회전 2 · bag 10 · base_footprint 5 · base_link 1 · ConnectivityException 9 · ExtrapolationException 9 · InvalidArgumentException 9 · LookupException 9 · map 5 · odom 5 · QoS 6 · REP-103 2 · REP-105 5 · robot_state_publisher 7 · RViz 0 · tcp 7 · TF 트리 4 · TF2 0 · tf2_echo 3 · tf2_monitor 11 · timeout 9 · TimeoutException 9 · TransformException 9 · TypeException 8 · URDF 7 · view_frames 4

# %% [markdown] lang="en" name="chapter-0" slide="skip"
# ## Chapter 0 · Start here
#
# - **TF2 (좌표 변환 시스템)**: The part of ROS 2 that stores the transforms between frames over time, and combines them for a lookup.
# - **node (노드)**: One participant of a ROS 2 system: a program, or a part of one, with a name.
# - **topic (토픽)**: A named channel on which nodes publish messages and others subscribe to them.
# - **message (메시지)**: A value of a fixed type that travels on a topic.
# - **RViz**: ROS 2's 3D visualiser. It draws frames, scans, clouds and the robot, all in one fixed frame.
# - **publish (발행)**: To send a message, or a transform, to all subscribers.

# %% [markdown] lang="ko" name="chapter-0" slide="skip"
# ## 0장 · 여기서 시작합니다
#
# - **좌표 변환 시스템 (TF2)**: 좌표계 사이의 위치와 방향을 시각마다 보관해 두고, 조회하면 필요한 변환을 합성해 주는 ROS 2의 라이브러리와 통신 체계입니다.
# - **노드 (node)**: 이름을 가지고 ROS 2 통신에 참여하는 단위로, 프로그램이거나 그 일부입니다.
# - **토픽 (topic)**: 노드가 메시지를 발행하고 다른 노드가 구독하는, 이름 붙은 통로입니다.
# - **메시지 (message)**: 토픽을 통해 전달되는, 형식이 정해진 값입니다.
# - **RViz**: 좌표계, 스캔, 포인트 클라우드, 로봇을 하나의 고정 좌표계 기준으로 그려 보여 주는 ROS 2의 화면 도구입니다.
# - **발행 (publish)**: 메시지나 변환을, 구독하는 모든 노드에 보내는 일입니다.

# %% [markdown] lang="en" name="chapter-1" slide="skip"
# ## Chapter 1 · Value, frame and stamp
#
# - **frame (좌표계)**: An origin and three axes, with a name. Positions and directions are measured in a frame.
# - **base_link (로봇 본체 좌표계)**: The frame that is fixed to the robot's body. Sensors are mounted on it.
# - **pose (포즈)**: A position together with an orientation, both in one frame.
# - **stamp (측정 시각)**: The time at which something was measured, carried in `header.stamp`; not the time it was sent or received.
# - **header (헤더)**: The part of a message that contains the frame and the stamp of its values.

# %% [markdown] lang="ko" name="chapter-1" slide="skip"
# ## 1장 · 값, 좌표계, 측정 시각
#
# - **좌표계 (frame)**: 위치와 방향을 숫자로 적을 때 기준이 되는 원점과 x·y·z 축입니다. 현장에서는 흔히 프레임이라고 부릅니다.
# - **로봇 본체 좌표계 (base_link)**: 로봇 본체에 고정되어 함께 움직이며 센서 장착 변환의 기준이 되는 좌표계입니다.
# - **포즈 (pose)**: 한 좌표계를 기준으로 한 위치와 방향을 함께 이르는 말입니다.
# - **측정 시각 (stamp)**: 값을 보내거나 받은 때가 아니라 잰 때를 뜻하며, `header.stamp`에 들어 있습니다.
# - **헤더 (header)**: 메시지의 값이 어느 좌표계 기준이고 어느 시각의 값인지를 적은 부분입니다.

# %% [markdown] lang="en" name="chapter-2" slide="skip"
# ## Chapter 2 · Axes and quaternions
#
# - **rotation (회전)**: The part of a transform that gives the orientation of the child's axes in the parent.
# - **roll, pitch, yaw (롤·피치·요)**: Three rotations about the fixed x, y and z axes, in that order, in radians.
# - **yaw (요)**: The rotation about z, which points up. Positive is to the left.
# - **quaternion (쿼터니언)**: Four numbers for one rotation, in the order x, y, z, w, with length 1; (0, 0, 0, 1) is no rotation.
# - **unit quaternion (단위 쿼터니언)**: A quaternion of length 1. Only unit quaternions are rotations.
# - **REP-103**: ROS's convention for units and axes: metres, radians, right-handed; x forward, y left, z up.
# - **body frame (본체 축 좌표계)**: A frame with REP-103's axes: x forward, y left, z up.
# - **optical frame (광학 좌표계)**: A camera's second frame, with the axes of its image: z forward, x right, y down.
# - **right-handed (오른손 좌표계)**: Axes such that, with the thumb along z, the fingers of a right hand curl from x to y.
# - **gimbal lock (짐벌 락)**: What happens to roll, pitch and yaw when the nose points straight up or down: two of the three rotate about the same line, and small motions make the angles jump.
# - **detector (검출기)**: A program that finds objects in an image or a scan, and publishes their positions.
# - **point cloud (포인트 클라우드)**: Many measured points in one message, all in one frame: what a depth camera gives.

# %% [markdown] lang="ko" name="chapter-2" slide="skip"
# ## 2장 · 좌표축과 쿼터니언
#
# - **회전 (rotation)**: 부모 좌표계를 기준으로 자식의 축이 얼마나 회전해 있는지를 적은, 변환의 한 부분입니다.
# - **롤·피치·요 (roll, pitch, yaw)**: 고정된 x축, y축, z축을 차례로 중심으로 하는 세 번의 회전이며 단위는 라디안입니다.
# - **요 (yaw)**: 위를 향한 z축을 중심으로 하는 회전이며, 양수는 왼쪽입니다.
# - **쿼터니언 (quaternion)**: 회전 하나를 나타내는 숫자 네 개로 순서는 x, y, z, w이고 길이는 1이며, (0, 0, 0, 1)이 회전 없음입니다.
# - **단위 쿼터니언 (unit quaternion)**: 길이가 1인 쿼터니언이며, 이것만이 회전을 나타냅니다.
# - **REP-103**: ROS의 단위와 축 규약으로 미터, 라디안, 오른손 좌표계를 쓰며 x는 앞, y는 왼쪽, z는 위입니다.
# - **본체 축 좌표계 (body frame)**: REP-103의 축을 따르는 좌표계로 x는 앞, y는 왼쪽, z는 위입니다.
# - **광학 좌표계 (optical frame)**: 카메라 영상의 축을 따르는 두 번째 좌표계로 z는 앞, x는 오른쪽, y는 아래입니다.
# - **오른손 좌표계 (right-handed)**: 오른손 엄지를 z로 두면 나머지 손가락이 x에서 y로 감기는 축 배치입니다.
# - **짐벌 락 (gimbal lock)**: x축(정면)이 똑바로 위나 아래를 향할 때 roll, pitch, yaw 가운데 둘의 회전축이 같은 직선이 되는 현상입니다. 이 근처에서는 작은 움직임에도 각도가 크게 튑니다.
# - **검출기 (detector)**: 영상이나 스캔에서 물체를 찾아 그 위치를 알려 주는 프로그램입니다.
# - **포인트 클라우드 (point cloud)**: 한 좌표계로 적은 수많은 측정점을 담은 메시지입니다. 깊이 카메라에서 나옵니다.

# %% [markdown] lang="en" name="chapter-3" slide="skip"
# ## Chapter 3 · Target and source
#
# - **transform (좌표 변환)**: The pose of a child frame in its parent frame: a translation and a rotation.
# - **parent frame (부모 좌표계)**: The frame in which a transform says where the child is; `header.frame_id` in the message.
# - **child frame (자식 좌표계)**: The frame whose pose a transform gives. It has one parent only; `child_frame_id` in the message.
# - **tf2_echo (변환 확인 도구)**: A tool that keeps printing the newest transform between two frames: `tf2_echo A B` gives the pose of B in A.
# - **target frame (목표 좌표계)**: The frame in which you want the data: the first argument of `lookup_transform`.
# - **source frame (원본 좌표계)**: The frame in which the data is expressed now: the second argument of `lookup_transform`.
# - **translation (이동)**: The part of a transform that gives the position of the child's origin in the parent, in metres.
# - **inverse (역변환)**: The transform that undoes another one. Its rotation is the inverse rotation, and its translation is −R⁻¹t.
# - **lookup (조회)**: A request to a buffer for the transform between two frames at one time: `lookup_transform`.

# %% [markdown] lang="ko" name="chapter-3" slide="skip"
# ## 3장 · 목표 좌표계와 원본 좌표계
#
# - **좌표 변환 (transform)**: 부모 좌표계를 기준으로 한 자식 좌표계의 위치와 방향, 즉 이동과 회전입니다.
# - **부모 좌표계 (parent frame)**: 자식 좌표계의 위치와 방향을 적을 때 기준이 되는 좌표계이며, 메시지에서는 `header.frame_id`입니다.
# - **자식 좌표계 (child frame)**: 부모 좌표계를 기준으로 위치와 방향이 정해지는 좌표계입니다. 부모는 하나뿐이며, 메시지에서는 `child_frame_id`입니다.
# - **변환 확인 도구 (tf2_echo)**: 두 좌표계 사이의 최신 변환을 계속 출력하는 도구로, `tf2_echo A B`는 A를 기준으로 한 B의 포즈를 보여 줍니다.
# - **목표 좌표계 (target frame)**: 결과의 기준이 될 좌표계로, `lookup_transform`의 첫째 인자입니다.
# - **원본 좌표계 (source frame)**: 데이터가 지금 표현되어 있는 좌표계로, `lookup_transform`의 둘째 인자입니다. 소스 프레임이라고도 합니다.
# - **이동 (translation)**: 부모 좌표계를 기준으로 자식 원점이 어디 있는지를 미터로 적은, 변환의 한 부분입니다.
# - **역변환 (inverse)**: 다른 변환을 되돌리는 변환으로, 회전을 되돌리면서 이동도 함께 회전시켜야 합니다.
# - **조회 (lookup)**: 두 좌표계 사이의, 어느 시각의 변환을 버퍼에서 구하는 일입니다. `lookup_transform`으로 합니다.

# %% [markdown] lang="en" name="chapter-4" slide="skip"
# ## Chapter 4 · The tree of frames
#
# - **view_frames (TF 트리 시각화 도구)**: A tool that receives transforms for a few seconds and draws the tree of frames with rates and ages.
# - **TF tree (TF 트리)**: All frames, each with one parent except the root: no cycle, and one path between any two frames.
# - **edge (연결)**: A connection in the tree: a child, its parent, and the transforms between them over time.
# - **authority (발행자)**: The node that sends a transform; each child should have one only.
# - **path (경로)**: The edges between two frames of one tree: up to the frame that both share, and down.
# - **root (루트)**: A frame without a parent: a tree has one, and two roots are two trees.
# - **namespace (네임스페이스)**: A prefix of the names of a node's topics and services. It is never put before the frames in its messages.
# - **frame prefix (접두사)**: A word such as robot1/ before every frame of one robot, so that two robots do not share a frame by accident.

# %% [markdown] lang="ko" name="chapter-4" slide="skip"
# ## 4장 · 좌표계 트리
#
# - **TF 트리 시각화 도구 (view_frames)**: 몇 초 동안 변환을 모아 좌표계 트리와 발행률을 그림으로 그리는 도구입니다.
# - **TF 트리 (TF tree)**: 루트를 뺀 모든 좌표계가 부모를 하나씩 가진 구조로, 고리가 없고 어느 두 좌표계 사이에도 경로가 하나입니다.
# - **연결 (edge)**: 트리에서 부모와 자식 사이의 한 단계입니다. 둘 사이의 변환이 시각마다 들어 있습니다.
# - **발행자 (authority)**: 변환을 발행하는 노드이며, 자식 좌표계마다 하나여야 합니다.
# - **경로 (path)**: 한 트리의 두 좌표계 사이에 있는 연결들입니다. 둘이 만나는 좌표계까지 올라갔다가 내려갑니다.
# - **루트 (root)**: 부모가 없는 좌표계입니다. 트리마다 하나이며, 루트가 둘이면 트리도 둘입니다.
# - **네임스페이스 (namespace)**: 노드의 토픽과 서비스 이름 앞에 붙는 말입니다. 메시지 속의 좌표계 이름에는 붙지 않습니다.
# - **접두사 (frame prefix)**: robot1/처럼 한 로봇의 모든 좌표계 이름 앞에 붙이는 말입니다. 로봇 두 대가 우연히 같은 이름을 쓰는 일을 막습니다.

# %% [markdown] lang="en" name="chapter-5" slide="skip"
# ## Chapter 5 · map, odom, base_link
#
# - **map (지도 좌표계)**: The world-fixed frame in which the robot's pose stays right over hours, but may jump when localisation corrects it.
# - **odom (오도메트리 좌표계)**: The world-fixed frame in which the robot moves without jumps, and slowly drifts away from the truth.
# - **base_footprint (지면 투영 좌표계)**: The robot's body projected onto the ground: x, y and yaw, without height, roll or pitch.
# - **REP-105**: ROS's convention for the frames of a mobile robot: map, odom, base_link, and which program publishes each.
# - **odometry (오도메트리)**: Motion added up step by step from wheels, an IMU or a camera.
# - **localization (위치 추정)**: Finding the robot in a map, and correcting what odometry has drifted.
# - **drift (드리프트)**: An error that grows slowly because small errors are added up.

# %% [markdown] lang="ko" name="chapter-5" slide="skip"
# ## 5장 · map, odom, base_link
#
# - **지도 좌표계 (map)**: 세계에 고정된(world-fixed) 기준 좌표계입니다. 오래 지나도 실제 공간과 어긋나지 않지만, 위치 추정이 보정될 때 로봇의 포즈가 튈 수 있습니다.
# - **오도메트리 좌표계 (odom)**: 세계에 고정된(world-fixed) 기준 좌표계입니다. 이 좌표계를 기준으로 로봇은 끊김 없이 움직이지만, 오차가 조금씩 쌓여 실제 위치와 멀어집니다.
# - **지면 투영 좌표계 (base_footprint)**: 로봇 본체를 지면에 투영한 좌표계로, 높이와 roll, pitch 없이 x, y, yaw만 가집니다.
# - **REP-105**: 이동 로봇의 좌표계 map, odom, base_link의 뜻과, 각 변환을 어느 노드가 맡는지를 정한 ROS의 규약입니다.
# - **오도메트리 (odometry)**: 바퀴, IMU, 카메라로 잰 움직임을 조금씩 더해 얻은 이동량입니다.
# - **위치 추정 (localization)**: 지도에서 로봇의 위치를 찾아 오도메트리의 오차를 바로잡는 일입니다.
# - **드리프트 (drift)**: 작은 오차가 계속 더해져 천천히 커지는 오차입니다.

# %% [markdown] lang="en" name="chapter-6" slide="skip"
# ## Chapter 6 · Static and dynamic
#
# - **static transform (정적 좌표 변환)**: A transform that does not change, such as a sensor's mount; sent once on `/tf_static`. Listeners that join later receive it, too.
# - **dynamic transform (동적 좌표 변환)**: A transform that changes, such as the robot's pose; sent again and again on `/tf`, each time with its stamp.
# - **broadcaster (변환 발행기)**: The object with which a node publishes transforms: `TransformBroadcaster`, or `StaticTransformBroadcaster`.
# - **QoS (서비스 품질)**: The terms on which a topic is delivered: reliability, depth of history, durability.
# - **transient local (전송 후 보존)**: The durability by which a late subscriber still receives what was sent before; `/tf_static` uses it.

# %% [markdown] lang="ko" name="chapter-6" slide="skip"
# ## 6장 · 정적 변환과 동적 변환
#
# - **정적 좌표 변환 (static transform)**: 센서의 장착 변환처럼 변하지 않아 `/tf_static`으로 한 번 보내며, 나중에 참가한 수신기도 받는 변환입니다.
# - **동적 좌표 변환 (dynamic transform)**: 로봇의 포즈나 관절처럼 변하므로 측정 시각을 붙여 `/tf`로 계속 보내는 변환입니다.
# - **변환 발행기 (broadcaster)**: 노드가 변환을 발행할 때 쓰는 객체입니다(발행하는 노드는 발행자라고 합니다). `TransformBroadcaster`와 `StaticTransformBroadcaster`가 있습니다.
# - **서비스 품질 (QoS)**: 메시지를 전달하는 조건으로 신뢰성, 보관 개수, 지속성을 정합니다.
# - **전송 후 보존 (transient local)**: 나중에 참가한 구독자도 이미 보낸 메시지를 받게 하는 지속성 설정이며, `/tf_static`이 사용합니다.

# %% [markdown] lang="en" name="chapter-7" slide="skip"
# ## Chapter 7 · URDF and sensors
#
# - **URDF (로봇 모델 파일)**: The file that describes a robot's links and the joints that connect them, fixed and moving.
# - **robot_state_publisher (로봇 상태 발행자)**: The node that turns a URDF and joint states into transforms.
# - **link (링크)**: A rigid part of a robot, and the frame that is fixed to it.
# - **joint (관절)**: The connection of a child link to its parent: an origin and, if it moves, a movement about or along an axis.
# - **forward kinematics (정기구학)**: Joint positions in, the pose of the tip out: the product of the transforms of all joints.
# - **tcp (공구 중심점)**: Tool centre point: the frame at which a tool works, below `tool0`, where the arm ends.

# %% [markdown] lang="ko" name="chapter-7" slide="skip"
# ## 7장 · URDF와 센서
#
# - **로봇 모델 파일 (URDF)**: 로봇의 링크와, 링크를 연결하는 관절을 적은 파일입니다.
# - **로봇 상태 발행자 (robot_state_publisher)**: URDF와 관절 값에서 변환을 만들어 발행하는 노드입니다.
# - **링크 (link)**: 로봇의 단단한 부품 하나이며, 거기에 고정된 좌표계이기도 합니다.
# - **관절 (joint)**: 자식 링크가 부모 링크의 어디에 달려 있는지를 나타냅니다. origin이 있고, 움직이는 관절이면 축을 중심으로 회전하거나 축을 따라 이동합니다.
# - **정기구학 (forward kinematics)**: 관절 값에서 팔 끝의 포즈를 구하는 계산이며, 모든 관절의 변환을 합성합니다.
# - **공구 중심점 (tcp)**: 공구의 작업점을 나타내는 좌표계(tool centre point)이며, 팔이 끝나는 `tool0` 아래에 둡니다.

# %% [markdown] lang="en" name="chapter-8" slide="skip"
# ## Chapter 8 · Buffer and measurement time
#
# - **listener (변환 수신기)**: The object that subscribes to `/tf` and `/tf_static` and fills a buffer: `TransformListener`.
# - **buffer (변환 버퍼)**: The store of recent transforms, edge by edge. It answers lookups: the pose of one frame in another at a given time.
# - **fixed frame (고정 좌표계)**: The frame in which RViz draws everything. In `lookup_transform_full`, a frame that does not move between the two times.
# - **latest common time (최신 공통 시각)**: The newest time at which every edge of a path has data: the earliest of the edges' latest stamps. Static edges do not count.
# - **interpolation (보간)**: Finding a value between two samples: a straight line for the translation, the shortest arc for the rotation.
# - **extrapolation (외삽)**: Guessing a value outside the samples. tf2 raises an exception instead.
# - **cache time (보관 시간)**: How far back a buffer keeps samples: 10 s by default.
# - **latency (지연)**: The time between measuring something and using it.
# - **smear (번짐)**: A wall drawn thick or twice because scans were transformed with the pose of another time.
# - **TypeException (형식 예외)**: The error of `transform()` for a message type without a registered conversion. It is not a TransformException.
# - **motion distortion (움직임 왜곡)**: What a sensor's own motion does to data that takes time to measure: the rays of one sweep are measured at different times, so walls look bent if all are transformed with one pose.
# - **sample (표본)**: One transform of an edge, at the stamp it was measured at.
# - **timeline (시간줄)**: The samples of one edge, in the order of their stamps: the buffer keeps one for each edge.

# %% [markdown] lang="ko" name="chapter-8" slide="skip"
# ## 8장 · 버퍼와 측정 시각
#
# - **변환 수신기 (listener)**: `/tf`와 `/tf_static`을 구독해 버퍼를 채우는 객체, `TransformListener`입니다.
# - **변환 버퍼 (buffer)**: 최근의 변환을 연결마다 시간 순서로 담아 두고, 어느 시각에 한 좌표계가 다른 좌표계를 기준으로 어디에 있었는지 조회할 수 있는 저장소입니다.
# - **고정 좌표계 (fixed frame)**: 움직이지 않는다고 정해 둔 좌표계입니다. RViz는 모든 데이터를 이 좌표계 기준으로 바꾸어 그립니다.
# - **최신 공통 시각 (latest common time)**: 경로의 모든 연결에 값이 있는 가장 최근의 시각으로, 연결마다의 최신 시각 가운데 가장 이른 것이며 정적 변환은 세지 않습니다.
# - **보간 (interpolation)**: 두 표본 사이의 값을 구하는 일로, 이동은 직선을, 회전은 가장 짧은 호를 따라 구합니다.
# - **외삽 (extrapolation)**: 표본 바깥의 값을 짐작하는 일이며, tf2는 거절합니다.
# - **보관 시간 (cache time)**: 버퍼가 얼마나 오래된 표본까지 보관하는지를 이르며, 따로 정하지 않으면 10초입니다.
# - **지연 (latency)**: 무언가를 잰 때부터 그 값을 쓰는 때까지 걸린 시간입니다.
# - **번짐 (smear)**: 다른 시각의 로봇 포즈로 스캔을 그려 벽이 두껍게 또는 겹쳐 보이는 현상입니다.
# - **형식 예외 (TypeException)**: `transform()`에 그 메시지의 변환 방법이 등록되어 있지 않을 때 내는 예외이며, TransformException이 아닙니다.
# - **움직임 왜곡 (motion distortion)**: 측정에 시간이 걸리는 동안 센서 자신이 움직여 생기는 왜곡입니다. 한 번 훑는 동안의 광선은 저마다 잰 순간이 달라, 포즈 하나로 그리면 벽이 휘어 보입니다.
# - **표본 (sample)**: 한 연결의 변환 하나로, 측정 시각이 붙어 있습니다. 샘플이라고도 합니다.
# - **시간줄 (timeline)**: 한 연결의 표본을 측정 시각 순서로 늘어놓은 것입니다. 버퍼에는 연결마다 하나씩 있습니다.

# %% [markdown] lang="en" name="chapter-9" slide="skip"
# ## Chapter 9 · Exceptions and waiting
#
# - **LookupException (좌표계 조회 예외)**: TF2's error for a frame name that the buffer has never received.
# - **ConnectivityException (연결 예외)**: TF2's error for two frames that are known but have no path between them.
# - **ExtrapolationException (시간 외삽 예외)**: TF2's error for a path that exists but has no data at the requested time.
# - **InvalidArgumentException (잘못된 인자 예외)**: TF2's error for an invalid argument, such as an empty name or one with a leading slash.
# - **TimeoutException (시간 초과 예외)**: TF2's error for a lookup in another process that was not answered in time.
# - **TransformException (변환 예외)**: The common parent of TF2's errors: `except TransformException` catches them all.
# - **timeout**: How long a lookup may wait for the transform before it gives up.
# - **callback (콜백)**: Your function that ROS 2 calls when a message arrives or a timer is due.
# - **executor (실행기)**: The object that runs a node's callbacks, one at a time or on several threads.
# - **thread (스레드)**: One line of execution in a program; while it waits, it does nothing else.
# - **clock offset (시계 차이)**: A constant difference between two computers' clocks; waiting never makes it go away.
# - **transport delay (전송 지연)**: The time a message takes from sender to receiver; a short wait absorbs it.
# - **jitter (지터)**: How much a delay or a period varies from one message to the next.
# - **message filter (메시지 필터)**: A queue that holds each message until its transform is there, and drops it when that takes too long.
# - **future (퓨처)**: An object for a result that is not there yet. When it is completed, `result()` returns the value or raises the exception.
# - **reentrant (재진입)**: A group of callbacks that several threads may run at the same time.

# %% [markdown] lang="ko" name="chapter-9" slide="skip"
# ## 9장 · 예외와 기다림
#
# - **좌표계 조회 예외 (LookupException)**: 버퍼에 없는 좌표계 이름을 조회할 때 나는 TF2 오류입니다.
# - **연결 예외 (ConnectivityException)**: 두 좌표계가 모두 버퍼에 있지만 둘을 연결하는 경로가 없을 때 나는 TF2 오류입니다.
# - **시간 외삽 예외 (ExtrapolationException)**: 경로는 있지만 요청 시각의 값이 없을 때 나는 TF2 오류입니다.
# - **잘못된 인자 예외 (InvalidArgumentException)**: 빈 이름이나 슬래시로 시작하는 이름처럼 조회의 인자가 잘못되었을 때 나는 TF2 오류입니다.
# - **시간 초과 예외 (TimeoutException)**: 정한 시간 안에 결과가 오지 않았을 때 나는 TF2 오류입니다.
# - **변환 예외 (TransformException)**: TF2 오류의 공통 부모로, `except TransformException`이 모두 잡습니다.
# - **timeout**: 변환이 올 때까지 조회가 기다려도 되는 가장 긴 시간입니다.
# - **콜백 (callback)**: 메시지가 도착하거나 타이머 시각이 되면 ROS 2가 호출하는 함수입니다.
# - **실행기 (executor)**: 대기 중인 콜백을 꺼내 하나씩, 또는 여러 스레드에서 실행하는 객체입니다.
# - **스레드 (thread)**: 프로그램 안의 실행 흐름 하나로, 기다리는 동안에는 다른 일을 하지 못합니다.
# - **시계 차이 (clock offset)**: 두 컴퓨터의 시계가 늘 일정하게 어긋난 정도이며, 기다려도 사라지지 않습니다.
# - **전송 지연 (transport delay)**: 메시지가 발행자에서 수신기까지 가는 데 걸리는 시간이며, 잠깐 기다리면 해결됩니다.
# - **지터 (jitter)**: 지연이나 주기가 메시지마다 들쭉날쭉한 정도입니다.
# - **메시지 필터 (message filter)**: 변환이 준비될 때까지 메시지를 보관하고, 너무 오래 걸리면 버리는 큐입니다.
# - **퓨처 (future)**: 나중에 나올 결과를 담는 객체입니다. 결과가 나오면 완료되고, 그때 결과나 예외를 꺼낼 수 있습니다.
# - **재진입 (reentrant)**: 여러 스레드가 동시에 실행해도 되는 콜백 그룹의 성질입니다.

# %% [markdown] lang="en" name="chapter-10" slide="skip"
# ## Chapter 10 · Clocks and bags
#
# - **simulation time (시뮬레이션 시간)**: Time that comes from `/clock` instead of the computer, for nodes with `use_sim_time`.
# - **bag**: A recording of topics that can be played back.

# %% [markdown] lang="ko" name="chapter-10" slide="skip"
# ## 10장 · 시계와 bag
#
# - **시뮬레이션 시간 (simulation time)**: `use_sim_time`을 켠 노드가 시스템 시간 대신 `/clock`에서 받는 시간입니다.
# - **bag**: 토픽을 기록해 두었다가 다시 재생할 수 있는 파일입니다.

# %% [markdown] lang="en" name="chapter-11" slide="skip"
# ## Chapter 11 · Tools and RViz
#
# - **tf2_monitor (변환 지연 감시 도구)**: A tool that measures how late and how often transforms arrive.
# - **owner (발행 책임)**: The node that publishes an edge, and the only one that should. No ROS 2 tool names it.
# - **display status (디스플레이 상태)**: What RViz shows below each entry of its list: Ok, Warn or Error. Ok means that RViz could compute what it draws, not that it is right.
# - **decay time (표시 유지 시간)**: How long RViz leaves a message on the screen; 0 means until the next one comes.
# - **snapshot (스냅샷)**: The output of a tool that records a few seconds. What happens outside of them is not in it.

# %% [markdown] lang="ko" name="chapter-11" slide="skip"
# ## 11장 · 도구와 RViz
#
# - **변환 지연 감시 도구 (tf2_monitor)**: 변환의 지연과 발행률을 재는 도구입니다.
# - **발행 책임 (owner)**: 한 연결을 한 노드만 발행해야 한다는, 그 노드의 책임입니다. 어느 노드인지 알려 주는 ROS 2 도구는 없습니다.
# - **디스플레이 상태 (display status)**: RViz 목록의 항목마다 붙는 Ok, Warn, Error입니다. Ok는 계산할 수 있었다는 뜻입니다.
# - **표시 유지 시간 (decay time)**: RViz가 메시지를 화면에 남겨 두는 시간입니다. 0이면 다음 메시지가 올 때까지입니다.
# - **스냅샷 (snapshot)**: 도구가 몇 초 동안 수신한 것입니다. 그 밖의 시간에 일어난 일은 알 수 없습니다.

# %% [markdown] lang="en" name="chapter-12" slide="skip"
# ## Chapter 12 · Owners and diagnosis
#
# - **second owner (두 번째 발행자)**: Another node that publishes the same edge. TF2 accepts both without an error, and the pose alternates.
# - **suspect (용의자)**: A cause that may be behind a complaint, as long as no check has ruled it out.
# - **evidence (증거)**: A result that some suspects would give, and others not. A result that all of them would give is no evidence.

# %% [markdown] lang="ko" name="chapter-12" slide="skip"
# ## 12장 · 발행 책임과 진단
#
# - **두 번째 발행자 (second owner)**: 같은 연결을 발행하는 또 다른 노드입니다. TF2는 오류 없이 둘 다 받고, 포즈는 번갈아 바뀝니다.
# - **용의자 (suspect)**: 증상의 원인일 수 있는 것입니다. 검사 결과로 제외될 때까지 용의자로 둡니다.
# - **증거 (evidence)**: 어떤 용의자라면 나오고 다른 용의자라면 나오지 않을 값입니다. 어느 용의자든 똑같이 나올 값은 증거가 아닙니다.
