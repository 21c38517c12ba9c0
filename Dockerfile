# The workbook in a container, for one learner or as the image of a hub:
#   docker build -t tflab .
#   docker run -p 8888:8888 -v "$PWD/my_workbook:/home/learner/tflab_workbook" tflab
FROM python:3.12-slim
COPY . /opt/tflab
RUN pip install --no-cache-dir --constraint /opt/tflab/constraints.txt "/opt/tflab[all]" && useradd --create-home learner
USER learner
WORKDIR /home/learner
RUN tflab lab tflab_workbook --copy-only
EXPOSE 8888
CMD ["tflab", "lab", "tflab_workbook", "--no-browser", "--", "--ip=0.0.0.0"]
